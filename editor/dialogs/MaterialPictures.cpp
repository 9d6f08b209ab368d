#include "editor/dialogs/MaterialPictures.h"

#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/MaterialSample.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr int kSamples = 16;             // of a picture
constexpr std::size_t kMaxKept = 256;    // pictures, of about 20 kB each
constexpr double kSampleExposure = 0.2;  // stops: small pictures look darker than large ones

QImage imageOf(const Image& image, double pixelRatio) {
    QImage made(image.width, image.height, QImage::Format_ARGB32);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto at = static_cast<std::size_t>(y * image.width + x);
            const std::uint8_t* pixel = image.pixels.data() + 3 * at;
            made.setPixel(x, y, qRgba(pixel[0], pixel[1], pixel[2], image.opacities[at]));
        }
    }
    made.setDevicePixelRatio(pixelRatio);
    return made;
}

Result<QImage> renderedSample(OffscreenRenderer& renderer, const MaterialPreset& preset, double pixelRatio,
                              const TaskContext& task) {
    const auto side = [&](int points) { return static_cast<int>(std::lround(points * pixelRatio)); };
    const std::shared_ptr<const RenderScene> scene = materialSample(materialOf(preset, 0));
    RenderView view{.size = {side(MaterialPictures::kSize.width()), side(MaterialPictures::kSize.height())}};
    view.settings.hasEdges = false;
    view.settings.hasOverlays = false;
    view.settings.exposure = kSampleExposure;
    view.camera = sampleCamera(*scene, view.size);
    const Result<Image> image = renderer.renderCutOut(scene, view, kSamples, task);
    if (!image) return image.error();
    return imageOf(*image, pixelRatio);
}

}  // namespace

MaterialPictures::MaterialPictures(QObject* parent) : QObject(parent) {}

MaterialPictures::Key MaterialPictures::keyOf(const MaterialPreset& preset, double pixelRatio) {
    return {preset.outside, preset.inside, preset.opacity, preset.finish, pixelRatio};
}

const MaterialPictures::Kept* MaterialPictures::find(const Key& key) const {
    const auto kept = std::ranges::find(m_kept, key, &Kept::key);
    return kept == m_kept.end() ? nullptr : &*kept;
}

QImage MaterialPictures::picture(const MaterialPreset& preset, double pixelRatio) const {
    const Kept* kept = find(keyOf(preset, pixelRatio));
    return kept ? kept->image : QImage();
}

void MaterialPictures::keep(const Key& key, const QImage& image) {
    if (m_kept.size() == kMaxKept) m_kept.erase(m_kept.begin());
    m_kept.push_back({key, image});
    emit pictureAdded();
}

void MaterialPictures::render(const std::vector<MaterialPreset>& presets, double pixelRatio) {
    std::vector<MaterialPreset> missing;
    for (const MaterialPreset& preset : presets) {
        if (!find(keyOf(preset, pixelRatio))) missing.push_back(preset);
    }
    m_job.start(
        [this, missing, pixelRatio](const TaskContext& task, const BackgroundJob::Post& post) -> Status {
            if (missing.empty()) return success();
            Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
            if (!renderer) return renderer.error();
            for (const MaterialPreset& preset : missing) {
                const Result<QImage> image = renderedSample(*renderer, preset, pixelRatio, task);
                if (!image) return image.error();
                post([this, key = keyOf(preset, pixelRatio), image = *image] { keep(key, image); });
            }
            return success();
        },
        [this](const Status&) { emit finished(); });
}

}  // namespace rubble

#include "moc_MaterialPictures.cpp"
