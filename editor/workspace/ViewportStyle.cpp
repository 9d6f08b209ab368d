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

void applyTheme(ViewportWidget& viewport) {
    RenderSettings settings = viewport.settings();
    settings.theme = isDark(viewport.palette()) ? Theme::Dark : Theme::Light;
    viewport.setSettings(settings);
}

}  // namespace rubble
