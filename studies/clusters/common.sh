# The sweep of both tests, and the comparison of its results.

cat > "$work/sweep.toml" <<END
scene = "granite-fault-small"

[[axis]]
key = "driving.pressure"
values = [14e6, 28e6]

[[axis]]
key = "time.end"
values = [2e-3]

[seeds]
setup = "0..4"

[[observe]]
column = "friction_load"
statistic = "mean"
END

"$gouge" sweep "$work/sweep.toml" --out "$work/plain" --quiet

compare() {
    "$gouge" sweep status "$work/sweep.toml" --out "$work/cluster"
    "$gouge" sweep collect "$work/sweep.toml" --out "$work/cluster"
    for run in "$work"/plain/runs/*; do
        for file in series.csv particles.csv; do
            cmp "$run/$file" "$work/cluster/runs/$(basename "$run")/$file"
        done
    done
    echo "the same bits as without a cluster"
}
