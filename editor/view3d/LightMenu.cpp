#include "editor/view3d/LightMenu.h"

#include "core/asset/project/Ranges.h"

#include <QActionGroup>
#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kExposureStep = 0.5;  // stops

/// With its sign.
QString stops(double exposure) {
    const QString text = QLocale().toString(std::abs(exposure), 'f', 1);
    return (exposure < 0.0 ? "\u2212" : "+") + text;
}

}  // namespace

LightMenu::LightMenu(QWidget* parent) : QMenu(parent), m_skies(new QActionGroup(this)) {
    setTitle(tr("&Light"));
    setObjectName("view-light");
    addSkies();
    addSeparator();
    addExposure();
    setLight(m_sky, {}, m_exposure, {});
}

void LightMenu::addSkies() {
    const std::pair<SkyPreset, QString> skies[] = {{SkyPreset::Studio, tr("&Studio")},
                                                   {SkyPreset::Overcast, tr("&Overcast Sky")},
                                                   {SkyPreset::Morning, tr("&Morning")},
                                                   {SkyPreset::Evening, tr("&Evening")},
                                                   {SkyPreset::Night, tr("&Night")}};
    for (const auto& [sky, text] : skies) {
        m_presetActions.append(addSky(text, sky, {}));
        addAction(m_presetActions.last());
    }
    m_fileAction = addAction(tr("Sky from &File…"));
    m_fileAction->setObjectName("view-sky-file");
    m_fileAction->setStatusTip(tr("Light the scene by the picture of a sky, an .hdr file"));
    connect(m_fileAction, &QAction::triggered, this, &LightMenu::fileRequested);
}

QAction* LightMenu::addSky(const QString& text, SkyPreset sky, const QString& file) {
    auto* action = new QAction(text, this);
    action->setCheckable(true);
    action->setStatusTip(tr("Light the scene by this sky"));
    m_skies->addAction(action);
    connect(action, &QAction::triggered, this, [this, sky, file] { emit lightSelected(sky, file, m_exposure); });
    return action;
}

/// Below the action for others.
void LightMenu::setRecentFiles(const QStringList& paths) {
    if (paths == m_recentFiles) return;
    m_recentFiles = paths;
    qDeleteAll(m_fileActions);
    m_fileActions.clear();
    const qsizetype next = actions().indexOf(m_fileAction) + 1;
    QAction* below = actions().value(next);
    for (const QString& path : paths) {
        QString name = QFileInfo(path).fileName();
        QAction* action = addSky(name.replace('&', "&&"), SkyPreset::Studio, path);
        action->setStatusTip(QDir::toNativeSeparators(path));
        insertAction(below, action);
        m_fileActions.append(action);
    }
}

void LightMenu::addExposure() {
    addStop(tr("&Brighter"), tr("Raise the exposure by half a stop"), kExposureStep);
    addStop(tr("&Darker"), tr("Lower the exposure by half a stop"), -kExposureStep);
    m_resetAction = addAction(QString());
    m_resetAction->setStatusTip(tr("Set the exposure to its default"));
    connect(m_resetAction, &QAction::triggered, this, [this] { emit lightSelected(m_sky, m_file, 0.0); });
}

void LightMenu::addStop(const QString& text, const QString& tip, double change) {
    QAction* action = addAction(text);
    action->setStatusTip(tip);
    connect(action, &QAction::triggered, this, [this, change] {
        const NumberRange& range = rangeOf(ProjectNumber::Exposure);
        emit lightSelected(m_sky, m_file, std::clamp(m_exposure + change, range.min, range.max));
    });
}

void LightMenu::setLight(SkyPreset sky, const QString& file, double exposure, const QStringList& recent) {
    m_sky = sky;
    m_file = file;
    m_exposure = exposure;
    m_resetAction->setText(exposure == 0.0 ? tr("&Reset Exposure")
                                           : tr("&Reset Exposure of %1 Stops").arg(stops(exposure)));
    m_resetAction->setEnabled(exposure != 0.0);
    setRecentFiles(recent);
    for (qsizetype k = 0; k < m_presetActions.size(); ++k)
        m_presetActions[k]->setChecked(file.isEmpty() && static_cast<qsizetype>(sky) == k);
    for (qsizetype k = 0; k < m_fileActions.size(); ++k) m_fileActions[k]->setChecked(recent[k] == file);
}

}  // namespace rubble

#include "moc_LightMenu.cpp"
