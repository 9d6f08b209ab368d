#include "editor/ViewportLook.h"

#include "editor/Theme.h"
#include "viewport/ViewportWidget.h"

namespace rubble {

void takePreferences(ViewportWidget& viewport, const Preferences& preferences) {
    const bool isMaya = preferences.navigation == NavigationChoice::Maya;
    viewport.setNavigation(isMaya ? NavigationStyle::Maya : NavigationStyle::Blender);
    viewport.setFlights(preferences.isSmooth);
    viewport.setRefining(preferences.refining);
    RenderSettings settings = viewport.settings();
    settings.msaa = preferences.msaa;
    viewport.setSettings(settings);
}

void takeTheme(ViewportWidget& viewport) {
    RenderSettings settings = viewport.settings();
    settings.theme = isDark(viewport.palette()) ? Theme::Dark : Theme::Light;
    viewport.setSettings(settings);
}

}  // namespace rubble
