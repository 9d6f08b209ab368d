#pragma once

#include <QComboBox>

namespace rubble {

class DocumentFile;

/// Selects what a simulation starts from: the scene, or a state beside the project.
class StateField : public QComboBox {
    Q_OBJECT
public:
    explicit StateField(const DocumentFile& file, QWidget* parent = nullptr);

    /// The name of the state's file; empty: the scene.
    QString state() const { return currentData().toString(); }
    /// Also of one that is missing. Emits no signal.
    void setState(const QString& name);

    /// Lists the states that there are now.
    void showPopup() override;

signals:
    /// The user selected another state.
    void edited(const QString& name);

private:
    void fill(const QString& selected);

    const DocumentFile& m_file;
};

}  // namespace rubble
