#pragma once

#include <QList>
#include <QStandardPaths>
#include <QString>

#include <functional>

class QDialog;
class QFormLayout;
class QFileDialog;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QVariant;

namespace rubble {

class DocumentFile;

// What dialogs share that ask for a file to write: pictures and videos.

/// The name of a file that is written, without a suffix, and its folder.
struct OutputDefaults {
    QString name;
    QString folder;
};
/// The name of the project and its folder; for a project without a file, a folder of the user.
OutputDefaults outputDefaults(const DocumentFile& file, QStandardPaths::StandardLocation folder);

/// Returns "<folder>/<name><suffix>", with a number if that exists with or without the suffix.
QString unusedPath(const QString& folder, const QString& name, const QString& suffix);

/// Returns unusedPath() in native notation, in the folder of a setting if that exists, else in `folder`.
QString unusedPathIn(const QVariant& setting, const QString& folder, const QString& name, const QString& suffix);

/// Lets a dialog that saves a file begin in the folder of the project, with an unused name after it.
void suggestOutput(QFileDialog& dialog, const DocumentFile& file, const QString& suffix);

/// Why a file may not be written, as a sentence: it is the project, a file of an export, or something else by its
/// suffix. Empty if it may. `suffixes`: ".png"; none: any.
QString outputFault(const QString& path, const QString& project, const QStringList& suffixes);

/// Runs a dialog that saves a file. Returns its path; nothing if it was cancelled, or after a message that the file may
/// not be written, see outputFault().
QString askForOutput(QFileDialog& dialog, const DocumentFile& file, const QStringList& suffixes);

/// A kind of file: the filter that a dialog shows for it, and its suffix without a period.
struct FileKind {
    QString filter;
    QString suffix;
};
/// Lets a dialog that saves a file offer kinds, the first as default: the suffix of the name follows the filter.
void offerKinds(QFileDialog& dialog, const QList<FileKind>& kinds);

/// Returns a label whose mnemonic leads to a control.
QLabel* buddyLabel(const QString& text, QWidget* buddy);

/// Adds a row with a plain text of several lines, which says what will be written or what is wrong.
QLabel* addSummary(QFormLayout& form, const QString& objectName);

/// Adds Cancel and the default button that accepts the dialog, which is returned.
QPushButton* addOutputButtons(QDialog& dialog, QFormLayout& form, const QString& accept);

/// Makes a dialog wide enough for a path.
void fitPath(QDialog& dialog);

/// Returns a row with the field of a path and a Browse button.
QHBoxLayout* createPathRow(QLineEdit& path, std::function<void()> browse);

}  // namespace rubble
