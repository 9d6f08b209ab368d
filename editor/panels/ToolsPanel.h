#pragma once

#include "editor/document/Document.h"
#include "editor/panels/Units.h"
#include "editor/play/PlayController.h"

#include <QWidget>

class QComboBox;

namespace rubble {

class NumberField;
class Section;

/// The dock with what is thrown, struck and blown up while playing: what kind, how large, how heavy, how fast.
class ToolsPanel : public QWidget {
    Q_OBJECT
public:
    ToolsPanel(const Document& document, PlayController& controller, QWidget* parent = nullptr);

    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);

private:
    NumberField* addField(Section& section, const QString& label, const QString& hint, const QString& unit,
                          const std::function<double&(PlayTools&)>& member);
    void addThrow(Section& section);
    void takeKind(int index);
    void offerAssets();
    void show();

    struct Bound {
        NumberField* field;
        std::function<double&(PlayTools&)> member;
    };

    const Document& m_document;
    PlayController& m_controller;
    Section* m_throw;
    QComboBox* m_kind;
    QList<NumberField*> m_sizes;
    NumberField* m_mass = nullptr;
    std::vector<Bound> m_fields;
    std::vector<std::pair<Id, std::string>> m_offered;  // the project's assets
};

}  // namespace rubble
