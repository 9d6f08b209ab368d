#pragma once

#include "app/cli/console/CliContext.h"
#include "viewport/render/Renderer.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <string>
#include <vector>

namespace rubble {

class Command;

/// The options of 3D pictures on the command line.
struct PictureOptions {
    std::string size = "1280x720";
    std::string view = "iso";
    std::string colour = "material";
    std::string theme = "light";
    std::string sky = "studio";               // or the path of a file
    std::shared_ptr<const SkyLight> skyFile;  // of that, once it is loaded
    double exposure = 0.0;                    // stops
    bool isWireframe = false;
    bool hasHulls = false;
    bool hasBonds = false;
    bool hasNoOverlays = false;
    std::vector<std::string> overlays;  // of a simulation
    int samples = 32;
    std::string quality;  // in place of samples; empty: these
};

/// Adds --size and --view.
void addViewOptions(Command& command, PictureOptions& options);
/// Adds --colour, --theme, --sky, --exposure, --wireframe, --hulls, --bonds and --no-overlays.
void addStyleOptions(Command& command, PictureOptions& options);
/// Adds --overlay, for data of a simulation, after --no-overlays.
void addOverlayOption(Command& command, PictureOptions& options);
/// Adds --samples, whose default is that of `options`, and --quality.
void addSamplesOption(Command& command, PictureOptions& options);
/// Returns the number of samples that either asks for.
int samplesOf(const PictureOptions& options);
/// The same for each picture of a video.
int videoSamplesOf(const PictureOptions& options);

/// Returns the options for the contents of a scene: colouring, hulls and bonds.
SceneOptions sceneOptions(const PictureOptions& options);

PlayOverlays playOverlays(const PictureOptions& options);

/// Returns a box enlarged by the space that falling fragments need.
Box3 withSpaceForDebris(Box3 box);

/// Loads the sky if that is a file.
///
/// Errors: those of loadRadiance().
Status loadSkyFile(PictureOptions& options, const TaskContext& task);

/// Returns a view that frames a box; a sky file has been loaded.
RenderView pictureView(const PictureOptions& options, const Box3& framed);

}  // namespace rubble
