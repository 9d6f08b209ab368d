#include "editor/workspace/ViewportStyle.h"

#include "editor/widgets/ColourScheme.h"
#include "editor/widgets/numbers/Units.h"
#include "viewport/render/ScaleBar.h"
#include "viewport/widget/ViewportWidget.h"

#include <QEvent>

namespace rubble {

namespace {

/// Sees the view's own change of palette: a parent is notified before its children have the new one.
class PaletteFollower : public QObject {
public:
    explicit PaletteFollower(ViewportWidget& viewport) : QObject(&viewport), m_viewport(viewport) {
        viewport.installEventFilter(this);
        apply();
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::PaletteChange) apply();
        return QObject::eventFilter(watched, event);
    }

private:
    void apply() {
        RenderSettings settings = m_viewport.settings();
        settings.theme = themeOf(m_viewport.palette());
        m_viewport.setSettings(settings);
    }

    ViewportWidget& m_viewport;
};

}  // namespace

void applyPreferences(ViewportWidget& viewport, const Preferences& preferences) {
    viewport.setNavigation(preferences.navigation);
    viewport.setCameraAnimation(preferences.isSmooth);
    viewport.setProgressiveRendering(preferences.refining);
    viewport.setQuality(preferences.quality);
    const NumberFormat lengths = Units{preferences.unit}.lengths();
    const bool isMetric = preferences.unit == LengthUnit::Metre;  // then the bar selects the unit by its length
    viewport.setScaleUnit(isMetric ? ScaleUnit{} : ScaleUnit{lengths.size(), lengths.unit.toStdString()});
    RenderSettings settings = viewport.settings();
    settings.msaa = preferences.msaa;
    settings.sky = preferences.sky;
    settings.exposure = preferences.exposure;
    viewport.setSettings(settings);
}

Theme themeOf(const QPalette& palette) { return isDark(palette) ? Theme::Dark : Theme::Light; }

void followPalette(ViewportWidget& viewport) { new PaletteFollower(viewport); }

}  // namespace rubble
