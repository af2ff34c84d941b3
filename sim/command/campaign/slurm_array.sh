#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# slurm_array.sh: the lines of a campaign as an array of Slurm: `sbatch --array=1-TASKS slurm_array.sh LINES`.
#
# Task i of TASKS runs lines i, i + TASKS, and so on, one after the other, and fails when one of them does. A task that
# Slurm repeats, or an array that is submitted again, measures only what is not kept: each line sees to that itself.
#SBATCH --job-name=pipegs
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
status=0
line=$SLURM_ARRAY_TASK_ID
lines=$(wc -l < "$1") || exit 2
while [ "$line" -le "$lines" ]; do
  sh -c "$(sed -n "${line}p" "$1")" || status=1
  line=$((line + SLURM_ARRAY_TASK_COUNT))
done
exit $status
