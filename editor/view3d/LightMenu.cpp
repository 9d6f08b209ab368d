#include "editor/view3d/LightMenu.h"

#include "core/asset/project/Ranges.h"

#include <QActionGroup>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kExposureStep = 0.5;  // stops

}  // namespace

LightMenu::LightMenu(QWidget* parent) : QMenu(parent), m_skies(new QActionGroup(this)) {
    setTitle(tr("&Light"));
    setObjectName("view-light");
    addSkies();
    addSeparator();
    addExposure();
    setLight(m_sky, m_exposure);
}

void LightMenu::addSkies() {
    const std::pair<SkyPreset, QString> skies[] = {{SkyPreset::Studio, tr("&Studio")},
                                                   {SkyPreset::Overcast, tr("&Overcast Sky")},
                                                   {SkyPreset::Morning, tr("&Morning")},
                                                   {SkyPreset::Evening, tr("&Evening")},
                                                   {SkyPreset::Night, tr("&Night")}};
    for (const auto& [sky, text] : skies) {
        QAction* action = addAction(text);
        action->setCheckable(true);
        action->setData(static_cast<int>(sky));
        action->setStatusTip(tr("Light the scene by this sky"));
        m_skies->addAction(action);
        connect(action, &QAction::triggered, this, [this, value = sky] { emit lightSelected(value, m_exposure); });
    }
}

void LightMenu::addExposure() {
    addStop(tr("&Brighter"), tr("Raise the exposure by half a stop"), kExposureStep);
    addStop(tr("&Darker"), tr("Lower the exposure by half a stop"), -kExposureStep);
    QAction* reset = addAction(tr("&Reset Exposure"));
    reset->setStatusTip(tr("Set the exposure to its default"));
    connect(reset, &QAction::triggered, this, [this] { emit lightSelected(m_sky, 0.0); });
}

void LightMenu::addStop(const QString& text, const QString& tip, double change) {
    QAction* action = addAction(text);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, [this, change] {
        const NumberRange& range = rangeOf(ProjectNumber::Exposure);
        emit lightSelected(m_sky, std::clamp(m_exposure + change, range.min, range.max));
    });
}

void LightMenu::setLight(SkyPreset sky, double exposure) {
    m_sky = sky;
    m_exposure = exposure;
    for (QAction* action : m_skies->actions()) action->setChecked(action->data().toInt() == static_cast<int>(sky));
}

}  // namespace rubble

#include "moc_LightMenu.cpp"
