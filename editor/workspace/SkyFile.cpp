#include "editor/workspace/SkyFile.h"

#include "core/io/media/RadianceFile.h"
#include "editor/document/FilePath.h"
#include "viewport/render/light/SkyLight.h"

#include <utility>

namespace rubble {

namespace {

using Light = std::shared_ptr<const SkyLight>;

Result<Light> loadedLight(const std::filesystem::path& path, const TaskContext& task) {
    Result<RadianceImage> image = loadRadiance(path, task);
    if (!image) return image.error();
    return Light(std::make_shared<const SkyLight>(skyLightOf(std::move(*image))));
}

}  // namespace

SkyFile::SkyFile(QObject* parent) : QObject(parent) {}

void SkyFile::setPath(const QString& path) {
    if (path == m_path) return;
    m_path = path;
    m_job.cancel();
    if (path.isEmpty()) {
        if (std::exchange(m_light, nullptr)) emit lightChanged();
        return;
    }
    m_job.start(
        [path = toPath(path)](const TaskContext& task) { return loadedLight(path, task); },
        [this](Result<Light>&& light) {
            m_light = light ? *light : nullptr;
            emit lightChanged();
            if (light) return;
            emit failed(tr("%1 The studio lights the scene.").arg(QString::fromStdString(light.error().message)));
        });
}

}  // namespace rubble

#include "moc_SkyFile.cpp"
