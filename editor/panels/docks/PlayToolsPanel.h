#pragma once

#include "core/asset/project/Ranges.h"
#include "editor/document/Document.h"
#include "editor/play/PlayController.h"
#include "editor/widgets/numbers/Units.h"

#include <QWidget>

class QCheckBox;
class QComboBox;

namespace rubble {

class NumberField;
class Section;

/// The dock with the settings of the play tools: throw, hammer, blast and grab.
class PlayToolsPanel : public QWidget {
    Q_OBJECT
public:
    PlayToolsPanel(const Document& document, PlayController& controller, QWidget* parent = nullptr);

    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);

private:
    NumberField* addField(Section& section, const QString& label, const QString& hint, const NumberFormat& format,
                          ProjectNumber number, const std::function<double&(PlayToolSettings&)>& member);
    void addThrow(Section& section);
    void addSpeed(Section& section);
    void addHammer(Section& section);
    void applyKind(int index);
    void refreshAssets();
    void refresh();

    struct Bound {
        NumberField* field;
        std::function<double&(PlayToolSettings&)> member;
    };

    const Document& m_document;
    PlayController& m_controller;
    Section* m_throw;
    QComboBox* m_kind;
    QList<NumberField*> m_sizes;    // width, height and length; for a ball, the first is the diameter
    QList<NumberField*> m_lengths;  // the fields that follow the unit of length
    NumberField* m_mass = nullptr;
    QCheckBox* m_isSpeedAutomatic = nullptr;
    NumberField* m_speed = nullptr;
    QCheckBox* m_throwsOnClick = nullptr;
    Section* m_hammer = nullptr;
    QCheckBox* m_isRadiusAutomatic = nullptr;
    NumberField* m_hammerRadius = nullptr;
    std::vector<Bound> m_fields;
    std::vector<std::pair<Id, std::string>> m_assets;  // that the box lists
};

}  // namespace rubble
