. /work/w/h4/exp/env.sh
s=$1; v=$2; q=$3; shift 3
cd /work/w/h4/exp/r5
export X_SERVE=1 X_VARIANTS=$v X_CACHE=/work/w/h4/exp/r5/$s.$v$TAG.trace X_BATCH=/work/w/h4/exp/r5/$q
[ -e $X_CACHE ] || export X_DUMP=/work/w/h4/exp/r5/$s.$v$TAG
touch $q
exec $PR model ${A[$s]} "$@" --json
