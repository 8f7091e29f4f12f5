# ParaView, and where the plugin and everything it needs go: one folder, lib/paraview-5.11/plugins/Authalic.
# COMPONENTS are listed: without them ParaView looks for Qt. Its VTK comes with it and must not be looked for.
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager)
set(AUTHALIC_PLUGIN_DESTINATION "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Authalic")
