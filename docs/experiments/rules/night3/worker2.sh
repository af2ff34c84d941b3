# worker.sh: lines "SCENE NAME K=V ..." of todo, one at a time, with a slot (held for ten minutes at most)
cd /work/w/h4/exp/r5; touch todo2; n=0
while true; do
  while true; do exec 9>/work/w/slots/0; flock -n 9 && break; exec 9>/work/w/slots/1; flock -n 9 && break; exec 9>&-; sleep 0.2; done; t0=$(date +%s)
  while [ $(($(date +%s) - t0)) -lt 600 ]; do
    n=$((n+1)); line=$(sed -n ${n}p todo2)
    if [ -z "$line" ]; then n=$((n-1)); break; fi
    [ "$line" = end ] && exit
    case $line in "#"*) continue;; esac
    set -- $line; s=$1; shift
    if [ "$s" = do ]; then date +%T >> worker.log; "$@" 9>&- >> worker.log 2>&1; continue; fi
    rm -f $1.done; echo "$*" >> q_$s
    while [ ! -e $1.done ]; do sleep 0.5; done
  done
  exec 9>&-; sleep 3
done
