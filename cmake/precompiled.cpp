// Nothing but the headers that are compiled once for all (muster_compile_quickly in MusterTargets.cmake).
