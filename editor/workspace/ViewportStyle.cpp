#include "editor/workspace/ViewportStyle.h"

#include "editor/widgets/Theme.h"
#include "viewport/widget/ViewportWidget.h"

namespace rubble {

void applyPreferences(ViewportWidget& viewport, const Preferences& preferences) {
    viewport.setNavigation(preferences.navigation);
    viewport.setCameraAnimation(preferences.isSmooth);
    viewport.setProgressiveRendering(preferences.refining);
    RenderSettings settings = viewport.settings();
    settings.msaa = preferences.msaa;
    viewport.setSettings(settings);
}

Theme themeOf(const QPalette& palette) { return isDark(palette) ? Theme::Dark : Theme::Light; }

void applyTheme(ViewportWidget& viewport) {
    RenderSettings settings = viewport.settings();
    settings.theme = themeOf(viewport.palette());
    viewport.setSettings(settings);
}

}  // namespace rubble
