#pragma once

#include "core/asset/library/MaterialPreset.h"
#include "editor/document/jobs/BackgroundJob.h"

#include <QImage>

#include <vector>

namespace rubble {

/// Small pictures of materials, which are rendered in the background and kept. There are none without OpenGL.
class MaterialPictures : public QObject {
    Q_OBJECT
public:
    static constexpr QSize kSize{44, 44};  // points

    explicit MaterialPictures(QObject* parent = nullptr);

    /// The picture of a material's colours and finish at a number of pixels a point; null if there is none yet.
    QImage picture(const MaterialPreset& preset, double pixelRatio) const;
    /// Renders those of several materials that there are not yet, one after another.
    void render(const std::vector<MaterialPreset>& presets, double pixelRatio);
    bool isRendering() const { return m_job.isRunning(); }

signals:
    /// There is another picture.
    void pictureAdded();
    /// All that can be rendered are there.
    void finished();

private:
    /// What pictures depend on.
    struct Key {
        Colour outside, inside;
        double opacity = 1.0;
        Finish finish = Finish::Plain;
        double pixelRatio = 1.0;
        bool operator==(const Key&) const = default;
    };
    struct Kept {
        Key key;
        QImage image;
    };
    static Key keyOf(const MaterialPreset& preset, double pixelRatio);
    const Kept* find(const Key& key) const;
    void keep(const Key& key, const QImage& image);

    std::vector<Kept> m_kept;  // the oldest first
    BackgroundJob m_job;
};

}  // namespace rubble
