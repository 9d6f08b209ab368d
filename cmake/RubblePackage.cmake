# What is installed beside the programs, and the Debian package that is made of it (tools/package).
# tests/tools/InstallTest and PackageTest hold both against what they promise.

# What the programs read while they run. Not below share/doc, which small systems leave out.
install(DIRECTORY docs DESTINATION share/rubble)
install(DIRECTORY projects DESTINATION share/rubble FILES_MATCHING PATTERN "*.rubble" PATTERN "*.mesh")  # no locks
install(DIRECTORY resources/schemas DESTINATION share/rubble/resources)

# The README's links lead from share/doc/rubble to the same files.
install(FILES README.md CHANGELOG.md LICENSE DESTINATION share/doc/rubble)
foreach(folder docs projects resources)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/links)
  file(CREATE_LINK ../../rubble/${folder} ${PROJECT_BINARY_DIR}/links/${folder} SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/links/${folder} DESTINATION share/doc/rubble)
endforeach()

if(NOT UNIX OR APPLE)
  return()
endif()

# The freedesktop.org name of the program: of its desktop entry, icon, MIME type and description.
set(id io.github.rubble.Rubble)
set(linux ${PROJECT_SOURCE_DIR}/resources/linux)
install(FILES ${linux}/${id}.desktop DESTINATION share/applications)
install(FILES ${linux}/${id}.metainfo.xml DESTINATION share/metainfo)
install(FILES ${linux}/${id}.mime.xml DESTINATION share/mime/packages RENAME ${id}.xml)
install(FILES ${linux}/${id}.thumbnailer DESTINATION share/thumbnailers)
install(FILES ${linux}/rubble.1 ${linux}/rubble-cli.1 DESTINATION share/man/man1)
# Where the packages of the shells look for the completions of others.
set(completions ${PROJECT_BINARY_DIR}/completions)
install(FILES ${completions}/rubble-cli DESTINATION share/bash-completion/completions)
install(FILES ${completions}/_rubble-cli DESTINATION share/zsh/vendor-completions)
install(FILES ${completions}/rubble-cli.fish DESTINATION share/fish/vendor_completions.d)
install(FILES ${linux}/copyright DESTINATION share/doc/rubble)
set(hicolor share/icons/hicolor)
install(FILES resources/icons/rubble.svg DESTINATION ${hicolor}/scalable/apps RENAME ${id}.svg)
install(FILES ${linux}/icons/application-x-rubble.svg DESTINATION ${hicolor}/scalable/mimetypes)
foreach(size 16 24 32 48 64 128 256 512)
  install(FILES ${linux}/icons/${id}-${size}.png DESTINATION ${hicolor}/${size}x${size}/apps RENAME ${id}.png)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Rubble authors")
# Debian wants an address; the authors, as LICENSE names them, have none. ".invalid" says so (RFC 2606).
set(CPACK_PACKAGE_CONTACT "The Rubble authors <authors@rubble.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "editor of destructible assets")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Rubble makes solids breakable: an outline with a depth, or a mesh that is
such a prism, is cut into the Voronoi cells of seeds. The fragments are closed
and fill the whole without gaps; they have masses, inertia, neighbours and
collision hulls.
.
This package holds the editor, a command line that does the same, a manual,
examples, and a C++ header that loads what is exported.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Qt loads it as a plugin, too, which no library names.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libqt6svg6)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qt6-wayland")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS ffmpeg)  # for videos
# Desktop entry, MIME type and icons become known without scripts of ours: the packages that keep those databases watch
# their folders by triggers of dpkg.
include(CPack)
