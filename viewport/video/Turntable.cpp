#include "viewport/video/Turntable.h"

#include "core/base/math/Trigonometry.h"

namespace rubble {

FrameSource turntable(std::shared_ptr<const RenderScene> scene, const RenderView& view, int frames, int samples) {
    const auto frameAt = [scene = std::move(scene), view, frames, samples](OffscreenRenderer& renderer, int frame,
                                                                           const TaskContext& task) {
        RenderView turned = view;
        turned.camera = orbited(view.camera, kFullTurn * frame / frames, 0.0);
        return renderer.renderImage(scene, turned, samples, task);
    };
    return {frameAt, frames};
}

}  // namespace rubble
