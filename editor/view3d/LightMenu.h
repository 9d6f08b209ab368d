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

    /// Shows what is set. `file`: in place of the preset; empty: that. `recent`: files to select.
    void setLight(SkyPreset sky, const QString& file, double exposure, const QStringList& recent);

signals:
    void lightSelected(SkyPreset sky, const QString& file, double exposure);
    /// The user wants to select a file.
    void fileRequested();

private:
    QAction* addSky(const QString& text, SkyPreset sky, const QString& file);
    void setRecentFiles(const QStringList& paths);
    void addSkies();
    void addExposure();
    void addStop(const QString& text, const QString& tip, double change);

    QActionGroup* m_skies;
    QList<QAction*> m_presetActions;  // in the order of SkyPreset
    QAction* m_fileAction = nullptr;
    QAction* m_resetAction = nullptr;
    QList<QAction*> m_fileActions;  // of recent files
    QStringList m_recentFiles;
    SkyPreset m_sky = SkyPreset::Studio;
    QString m_file;
    double m_exposure = 0.0;  // stops
};

}  // namespace rubble
