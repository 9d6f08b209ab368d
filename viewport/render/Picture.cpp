#include "viewport/render/Picture.h"

#include "viewport/render/RenderTarget.h"
#include "viewport/render/SurfacelessContext.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace rubble {
namespace {

/// The colours of a framebuffer, top row first.
Image imageOf(const RenderTarget& target, PictureSize size) {
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

Result<Image> pictureOf(std::shared_ptr<const RenderScene> scene, const PictureView& view, int samples,
                        const TaskContext& task) {
    const auto [least, most] = std::minmax(view.size.width, view.size.height);
    if (least < 1 || most > kLargestPicture) {
        return Error{ErrorCode::BadInput, "A picture of " + std::to_string(view.size.width) + " x " +
                                              std::to_string(view.size.height) + " pixels: its sides can be 1 to " +
                                              std::to_string(kLargestPicture) + "."};
    }
    const auto context = SurfacelessContext::made();
    if (!context) return context.error();
    const auto renderer = Renderer::made();
    if (!renderer) return renderer.error();
    (*renderer)->setScene(std::move(scene));
    const RenderTarget target(view.size, PixelFormat::Colour, 1);
    if (samples == 0) (*renderer)->draw(view, target.framebuffer());
    for (int index = 0; index < samples; ++index) {
        if (task.isCancelled()) return TaskContext::cancelled();
        (*renderer)->addSample(view, index);
        glFinish();  // so that progress is true and cancelling quick
        task.report(static_cast<double>(index + 1) / samples);
    }
    if (samples > 0) (*renderer)->showMean(view, target.framebuffer());
    return imageOf(target, view.size);
}

}  // namespace rubble
