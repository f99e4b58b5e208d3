"""Files that survive a crash: durable writes, a lock, and a set of files changed as one."""
