#pragma once

#include "app/cli/Cli.h"
#include "viewport/render/Renderer.h"
#include "viewport/scene/MomentBuilder.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rubble {

/// How pictures in 3D are taken, as it is told on the command line.
struct PictureOptions {
    std::string size = "1280x720";
    std::string view = "iso";
    std::string colour = "material";
    std::string theme = "light";
    bool isWireframe = false;
    bool hasHulls = false;
    bool hasBonds = false;
    std::vector<std::string> overlays;  // of play
    int samples = 32;
};

/// --size and --view.
void addViewOptions(CLI::App& command, PictureOptions& options);
/// --colour, --theme, --wireframe, --hulls, --bonds.
void addLookOptions(CLI::App& command, PictureOptions& options);
/// --overlay, of what a moment of play shows beside bodies.
void addOverlayOption(CLI::App& command, PictureOptions& options);
/// --samples, whose default is what `options` has.
void addSamplesOption(CLI::App& command, PictureOptions& options);

/// The options with a say in what a scene holds: its colouring, hulls and bonds.
SceneOptions sceneOptions(const PictureOptions& options);

PlayOverlays playOverlays(const PictureOptions& options);

/// A box with room around it for what falls off it and is flung from it.
Box3 withRoomToFall(Box3 box);

/// A picture with a box in its middle, as large as fits.
PictureView pictureView(const PictureOptions& options, const Box3& framed);

}  // namespace rubble
