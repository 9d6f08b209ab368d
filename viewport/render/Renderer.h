#pragma once

#include "core/base/Result.h"
#include "viewport/render/RenderCounts.h"
#include "viewport/render/RenderSettings.h"
#include "viewport/scene/Camera.h"
#include "viewport/scene/RenderScene.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace rubble {

/// From where a picture is taken, how large and in what manner.
struct PictureView {
    Camera camera;
    PictureSize size;
    RenderSettings settings;
    std::optional<std::uint32_t> hovered;  // body under the pointer, drawn brighter
    double moment = 1.0;                   // in [0, 1]: from where bodies were a step before to where they are
    bool operator==(const PictureView&) const = default;
};

/// Draws scenes by OpenGL 3.3 core. The number of draw calls depends on the number of assets, not on that of pieces or
/// instances. Every call needs the same current context, the destructor too.
class Renderer {
public:
    /// Errors: Unsupported where the current context is older than OpenGL 3.3, or the driver refuses a shader.
    static Result<std::unique_ptr<Renderer>> made();
    ~Renderer();

    /// The scene that is drawn from now on. Uploads geometry that the last scene did not have, and a few numbers a body;
    /// what else it does does not grow with bodies where the scene has a summary.
    void setScene(std::shared_ptr<const RenderScene> scene);

    /// Draws a picture to a framebuffer: at once, lit by a sky that nothing hides.
    void draw(const PictureView& view, std::uint32_t framebuffer);

    /// Takes sample `index` (0 begins anew) of the same view, each lit from one place of the sky: the more, the softer
    /// light and edges.
    void addSample(const PictureView& view, int index);
    /// Draws the mean of the samples that were taken.
    void showMean(const PictureView& view, std::uint32_t framebuffer);

    const RenderCounts& counts() const;

    /// Whether the processor does the work of a graphics card.
    bool isSoftware() const;

    /// The body at a pixel (from the top left corner), as an index in RenderScene::picks. Quick for more pixels of the
    /// same view and scene.
    std::optional<std::uint32_t> bodyAt(const PictureView& view, int x, int y);

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace rubble
