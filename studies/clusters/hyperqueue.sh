#!/bin/bash
# Runs a sweep on a HyperQueue of this machine alone, kills its worker in the middle, and compares the results with
# those of a plain sweep. Needs the program hq (https://it4innovations.github.io/hyperqueue):
#
#     cargo build --release && studies/clusters/hyperqueue.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
gouge=$PWD/target/release/gouge
work=$(mktemp -d)
export HQ_SERVER_DIR=$work/server
trap 'hq server stop 2> /dev/null; rm -rf "$work"' EXIT
hq server start > "$work/server.log" 2>&1 &
sleep 1
worker() { hq worker start --cpus "$(nproc)" > "$work/worker.log" 2>&1 & worker=$!; }
worker

source studies/clusters/common.sh
"$gouge" sweep export hyperqueue "$work/sweep.toml" --out "$work/cluster" > "$work/job.sh"
sed -i 's/--array=0-0/--array=0-3/; s/--chunks 1/--chunks 4/' "$work/job.sh"
bash "$work/job.sh"
sleep 5
kill -KILL "$worker"
worker
hq job wait all || true
hq job list --all
compare
