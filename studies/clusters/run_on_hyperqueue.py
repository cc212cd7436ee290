#!/usr/bin/env python3
"""Run a sweep on a HyperQueue of this machine alone, kill a worker process in the middle, and compare the results with
those of a plain sweep. Needs the package hyperqueue, which holds the server but not the program hq:

    pip install hyperqueue && cargo build --release && python3 studies/clusters/run_on_hyperqueue.py
"""

import os
import subprocess
import tempfile
import threading
import time
from pathlib import Path

from hyperqueue import Job, LocalCluster

ROOT = Path(__file__).resolve().parents[2]
GOUGE = ROOT / "target/release/gouge"
CHUNKS = 4


def submit(client, command):
    """One task per chunk, with the command that the script for hq runs; whether all succeeded."""
    job = Job()
    for chunk in range(CHUNKS):
        job.program(["bash", "-c", command], env={"HQ_TASK_ID": str(chunk)})
    return client.wait_for_jobs([client.submit(job)], raise_on_error=False)


def main():
    with tempfile.TemporaryDirectory() as name:
        work = Path(name)
        common = f"work={work}; gouge={GOUGE}; source {ROOT}/studies/clusters/common.sh; "
        subprocess.run(["bash", "-ec", common], check=True)
        export = [GOUGE, "sweep", "export", "hyperqueue", work / "sweep.toml", "--out", work / "cluster"]
        script = subprocess.run(export, check=True, capture_output=True, text=True).stdout
        command = script.split("bash -c '", 1)[1].rsplit("'", 1)[0].replace(r"'\''", "'")
        command = command.replace("--chunks 1", f"--chunks {CHUNKS}").replace("exec ", "", 1)
        with LocalCluster() as cluster:
            cluster.start_worker()
            client = cluster.client()
            threading.Timer(4, lambda: os.system("pkill -KILL -o -f 'sweep work'")).start()
            print("all succeeded:", submit(client, command))
            # A run that lost its worker goes on by itself; wait for it before it is taken up again.
            while subprocess.run(["pgrep", "-f", f"gouge run .*{work}"], capture_output=True).returncode == 0:
                time.sleep(0.5)
            print("all succeeded:", submit(client, command))
        compare = f"work={work}; gouge={GOUGE}; source {ROOT}/studies/clusters/common.sh; compare"
        subprocess.run(["bash", "-ec", compare], check=True)


if __name__ == "__main__":
    main()
