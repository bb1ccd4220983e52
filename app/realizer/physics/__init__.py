"""Physics (NGS §3.4): the kinematic motion tracked by servos in a simulated body, so that momentum shows. An extra,
`understudy[physics]`."""
