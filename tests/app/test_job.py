import threading
import time

from workbench.app.job import Job


def until(condition, timeout=5.0):
    end = time.monotonic() + timeout
    while not condition() and time.monotonic() < end:
        time.sleep(0.005)
    return condition()


def chunks(number=400, value="done"):
    def work(progress):
        for step in range(number):
            progress(step / number, f"part {step}")
            time.sleep(0.005)
        return value

    return work


def test_result_and_progress():
    job, results, seen = Job("test"), [], []
    job.observe(lambda change: seen.append(change.new), "progress")
    job.start("a", chunks(60), results.append)
    assert until(lambda: job.state == "finished")
    assert results == ["done"]
    assert job.progress == 1.0
    assert seen == sorted(seen)
    assert len(seen) >= 2


def test_newest_request_wins():
    job, results = Job("test"), []
    job.start("old", chunks(400, "old"), results.append)
    assert until(lambda: job.progress >= 0)
    time.sleep(0.05)
    start = time.monotonic()
    job.start("new", chunks(2, "new"), results.append)
    assert until(lambda: job.state == "finished")
    assert results == ["new"]
    assert time.monotonic() - start < 1.0


def test_same_request_is_not_begun_twice():
    job, begun = Job("test"), []

    def work(progress):
        begun.append(1)
        time.sleep(0.1)

    for _ in range(3):
        job.start("a", work, lambda _: None)
    assert until(lambda: job.state == "finished")
    assert begun == [1]


def test_cancel_ends_the_work_at_its_next_report():
    job, results = Job("test"), []
    job.start("a", chunks(1000), results.append)
    time.sleep(0.05)
    job.cancel()
    assert job.state == "cancelled"
    time.sleep(0.1)
    assert results == []
    assert job.state == "cancelled"
    job.start("a", chunks(2), results.append)
    assert until(lambda: job.state == "finished")
    assert results == ["done"]


def test_cancel_before_the_delay_is_over():
    job, results = Job("test"), []
    job.start("a", chunks(2), results.append, delay=0.2)
    job.cancel()
    time.sleep(0.3)
    assert results == []


def test_failure_is_a_sentence_and_the_next_request_works():
    job, results = Job("test"), []

    def work(progress):
        raise ValueError("mass must be > 0 kg, got -1; check it.")

    job.start("a", work, results.append)
    assert until(lambda: job.state == "failed")
    assert job.error == "mass must be > 0 kg, got -1; check it."
    job.start("b", chunks(2), results.append)
    assert until(lambda: job.state == "finished")
    assert results == ["done"]
    assert job.error == ""


def test_work_runs_beside_the_caller():
    job, names = Job("test"), []
    job.start("a", lambda progress: names.append(threading.current_thread().name), lambda _: None)
    assert until(lambda: job.state == "finished")
    assert names == ["test job"]
