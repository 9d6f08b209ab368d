#pragma once

#include "core/base/Result.h"
#include "viewport/render/RenderCounts.h"
#include "viewport/render/RenderSettings.h"
#include "viewport/render/light/Lighting.h"
#include "viewport/scene/Camera.h"
#include "viewport/scene/RenderScene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace rubble {

/// Cracks between smaller fragments cannot be told apart.
inline constexpr double kMinFragmentPixels = 2.5;

/// The camera, the size and the settings of an image.
struct RenderView {
    Camera camera;
    ImageSize size;
    RenderSettings settings;
    std::optional<std::uint32_t> hovered;  // body under the pointer, drawn brighter
    double stepFraction = 1.0;             // in [0, 1]: interpolates from the previous poses to the current ones
    int skyMaps = kSkyDirections;          // that may be rendered for this image; others stay as they were before
    double resolution = 1.0;               // in (0, 1]: of the image that is drawn and scaled up to `size`
    // Intact instances whose fragments are smaller on average are drawn as a whole, without cracks.
    double minFragmentPixels = kMinFragmentPixels;
    bool operator==(const RenderView&) const = default;
};

/// Draws scenes with OpenGL 3.3 core. The number of draw calls depends on the number of assets, not of solids or
/// instances. All calls, including the destructor, need the same current context.
class Renderer {
public:
    /// Errors: Unsupported if the current context is older than OpenGL 3.3, or a shader does not compile.
    static Result<std::unique_ptr<Renderer>> create();
    ~Renderer();

    /// Sets the scene. Uploads geometry that the previous scene did not have and a few numbers per body; all else is
    /// independent of the number of bodies if the scene has a summary.
    void setScene(std::shared_ptr<const RenderScene> scene);

    /// Sets a function that another thread calls when an image of the scene has been decoded, so that updateTextures()
    /// uploads it. By default, setScene() waits for all.
    void setTextureListener(std::function<void()> listener);
    /// Whether pictures are different now.
    bool updateTextures();
    bool areTexturesPending() const;

    /// Sets a function that is called between draw calls of draw() and addSample(): once it returns true, these stop,
    /// return false and leave the framebuffer, or the sum of samples, as it was. Never by default.
    void setInterruption(std::function<bool()> isInterrupted);

    /// Draws to a framebuffer in one pass; false if it was interrupted.
    bool draw(const RenderView& view, std::uint32_t framebuffer);
    /// Draws the last image again; the view may differ in the hovered body alone.
    void drawAgain(const RenderView& view, std::uint32_t framebuffer);

    /// Accumulates sample `index` (0 restarts) of a view, each with light from other points of the sky and of the lamp:
    /// more samples give softer light and smoother edges. False if it was interrupted.
    bool addSample(const RenderView& view, int index);
    /// Draws the mean of the accumulated samples.
    void drawMean(const RenderView& view, std::uint32_t framebuffer);

    /// Waits until everything is drawn.
    void finish();

    const RenderCounts& counts() const;

    /// Whether a software rasterizer is used.
    bool isSoftware() const;

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace rubble
