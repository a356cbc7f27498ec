// Entry for notebooks: the model of the kernel is the source of data and state.
import { createView } from "./view.js";

export default {
  render({ model, el }) {
    const listeners = [];
    const source = {
      get: (name) => model.get(name),
      set(name, value) {
        if (model.get(name) === value) return;
        model.set(name, value);
        model.save_changes();
      },
      on(name, listener) {
        const event = name === "kernel" ? "comm_live_update" : `change:${name}`;
        model.on(event, listener);
        listeners.push([event, listener]);
      },
    };
    const dispose = createView(el, source, { height: model.get("height") });
    return () => {
      for (const [event, listener] of listeners) model.off(event, listener);
      dispose();
    };
  },
};
