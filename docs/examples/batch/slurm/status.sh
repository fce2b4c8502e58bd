#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# status.sh JOB: what has become of a Slurm job, without the accounting that sacct needs. A job that
# Slurm does not know any more counts as failed: it is done again unless its output is there.
state=$(scontrol -o show job "$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p')
case $state in
    COMPLETED) echo success ;;
    PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED) echo running ;;
    *) echo failed ;;
esac
