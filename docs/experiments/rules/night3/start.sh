# start.sh PROGRAM SCENE...: servers that run what worker.sh writes
for s in "${@:2}"; do
 cd /work/w/h4/exp/r5; : > q_$s
 (PR=$1 unshare -m bash -c 'mount --bind /work/w/h4 /src; cd /work/w/h4/exp/r5; . ../env.sh; export X_SERVE=2 X_VARIANTS=3500 X_CENTRES=/work/w/h4/exp/r5/'$s'.3500 X_CACHE=/work/w/h4/exp/r5/'$s'.3500.trace X_BATCH=/work/w/h4/exp/r5/q_'$s'; [ -e $X_CACHE ] || export X_DUMP=/work/w/h4/exp/r5/'$s'.3500; exec nice -n 10 $PR model ${A['$s']} --json' > serve_$s.log 2>&1 &)
done
