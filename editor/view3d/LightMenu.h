#pragma once

#include "viewport/render/RenderSettings.h"

#include <QMenu>

class QActionGroup;

namespace rubble {

/// The menu with the sky and the exposure of the 3D view.
class LightMenu : public QMenu {
    Q_OBJECT
public:
    explicit LightMenu(QWidget* parent);

    /// Shows what is set.
    void setLight(SkyPreset sky, double exposure);

signals:
    void lightSelected(SkyPreset sky, double exposure);

private:
    void addSkies();
    void addExposure();
    void addStop(const QString& text, const QString& tip, double change);

    QActionGroup* m_skies;
    SkyPreset m_sky = SkyPreset::Studio;
    double m_exposure = 0.0;  // stops
};

}  // namespace rubble
