#pragma once

#include "core/base/Result.h"
#include "viewport/render/Lighting.h"
#include "viewport/render/RenderCounts.h"
#include "viewport/render/RenderSettings.h"
#include "viewport/scene/Camera.h"
#include "viewport/scene/RenderScene.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace rubble {

/// The camera, the size and the settings of an image.
struct RenderView {
    Camera camera;
    ImageSize size;
    RenderSettings settings;
    std::optional<std::uint32_t> hovered;  // body under the pointer, drawn brighter
    double stepFraction = 1.0;             // in [0, 1]: interpolates from the previous poses to the current ones
    int skyMaps = kSkyDirections;          // that may be rendered for this image; others stay as they were before
    double resolution = 1.0;               // in (0, 1]: of the image that is drawn and scaled up to `size`
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

    /// Draws to a framebuffer in one pass.
    void draw(const RenderView& view, std::uint32_t framebuffer);
    /// Draws the last image again; the view may differ in the hovered body alone.
    void drawAgain(const RenderView& view, std::uint32_t framebuffer);

    /// Accumulates sample `index` (0 restarts) of a view, each with light from other points of the sky and of the lamp:
    /// more samples give softer light and smoother edges.
    void addSample(const RenderView& view, int index);
    /// The same in several short steps, between which the last image may be drawn again and bodies be picked; true
    /// after the last one. A sample that was begun is dropped by draw() and by one with another index.
    bool continueSample(const RenderView& view, int index);
    /// Draws the mean of the accumulated samples.
    void drawMean(const RenderView& view, std::uint32_t framebuffer);

    /// Waits until everything is drawn.
    void finish();

    const RenderCounts& counts() const;

    /// Whether a software rasterizer is used.
    bool isSoftware() const;

    /// The body at a pixel (from the top left corner), an index in RenderScene::picks. Fast for nearby pixels of the
    /// same view and scene.
    std::optional<std::uint32_t> bodyAt(const RenderView& view, int x, int y);

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace rubble
