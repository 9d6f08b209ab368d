#include "viewport/render/OffscreenRenderer.h"

#include "viewport/render/gl/RenderTarget.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace rubble {
namespace {

/// Reads back a render target, top row first.
Image imageOf(const RenderTarget& target, ImageSize size) {
    Image image{size.width, size.height, {}};
    const std::size_t row = 3 * static_cast<std::size_t>(size.width);
    image.pixels.resize(row * static_cast<std::size_t>(size.height));
    target.bind();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int y = 0; y < size.height; ++y) {
        std::uint8_t* pixels = image.pixels.data() + row * static_cast<std::size_t>(y);
        glReadPixels(0, size.height - 1 - y, size.width, 1, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    }
    return image;
}

}  // namespace

OffscreenRenderer::OffscreenRenderer(std::unique_ptr<SurfacelessContext> context, std::unique_ptr<Renderer> renderer)
    : m_context(std::move(context)), m_renderer(std::move(renderer)) {}

Result<OffscreenRenderer> OffscreenRenderer::create() {
    auto context = SurfacelessContext::create();
    if (!context) return context.error();
    auto renderer = Renderer::create();
    if (!renderer) return renderer.error();
    return OffscreenRenderer(std::move(*context), std::move(*renderer));
}

Result<Image> OffscreenRenderer::renderImage(std::shared_ptr<const RenderScene> scene, const RenderView& view,
                                             int samples, const TaskContext& task) {
    const auto [least, most] = std::minmax(view.size.width, view.size.height);
    if (least < 1 || most > kMaxImageSide) {
        return Error{ErrorCode::BadInput, "A picture of " + std::to_string(view.size.width) + " x " +
                                              std::to_string(view.size.height) + " pixels: its sides can be 1 to " +
                                              std::to_string(kMaxImageSide) + "."};
    }
    m_renderer->setScene(std::move(scene));
    const RenderTarget target(view.size, PixelFormat::Colour, 1);
    if (samples == 0) m_renderer->draw(view, target.framebuffer());
    for (int index = 0; index < samples; ++index) {
        if (task.isCancelled()) return TaskContext::cancelled();
        m_renderer->addSample(view, index);
        glFinish();  // else progress would run ahead and cancelling take long
        task.report(static_cast<double>(index + 1) / samples);
    }
    if (samples > 0) m_renderer->drawMean(view, target.framebuffer());
    return imageOf(target, view.size);
}

Result<Image> OffscreenRenderer::renderCutOut(const std::shared_ptr<const RenderScene>& scene, RenderView view,
                                              int samples, const TaskContext& task) {
    view.settings.background = Colour{0.0, 0.0, 0.0};
    const Result<Image> onBlack = renderImage(scene, view, samples, task.stage(0.0, 0.5));
    if (!onBlack) return onBlack.error();
    view.settings.background = Colour{1.0, 1.0, 1.0};
    const Result<Image> onWhite = renderImage(scene, view, samples, task.stage(0.5, 1.0));
    if (!onWhite) return onWhite.error();
    return cutOut(*onBlack, *onWhite);
}

Result<Image> renderImage(std::shared_ptr<const RenderScene> scene, const RenderView& view, int samples,
                          const TaskContext& task) {
    Result<OffscreenRenderer> maker = OffscreenRenderer::create();
    if (!maker) return maker.error();
    return maker->renderImage(std::move(scene), view, samples, task);
}

}  // namespace rubble
