#include "editor/dialogs/FilmDialog.h"

#include "core/asset/project/Ranges.h"
#include "core/io/media/FilmFile.h"
#include "core/io/media/PictureSequence.h"
#include "editor/dialogs/OutputPath.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/ComboBox.h"
#include "viewport/film/Film.h"
#include "viewport/render/OffscreenRenderer.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>

#include <cmath>

namespace rubble {

namespace {

constexpr int kSamples[] = {0, 8, 32};  // of each quality
constexpr const char* kFilmSuffix = ".mp4";
constexpr int kMinFilmDialogWidth = 480;  // pixels, so that a path fits
constexpr int kMinImageSide = 16;         // pixels

QHBoxLayout* createRow(const QList<QWidget*>& widgets) {
    auto* row = new QHBoxLayout;
    for (QWidget* widget : widgets) row->addWidget(widget);
    return row;
}

QLabel* createLabel(const QString& text, QWidget* buddy) {
    auto* label = new QLabel(text);
    label->setBuddy(buddy);
    return label;
}

QSpinBox* createIntegerField(int min, int max, const QString& suffix, const QString& name) {
    auto* box = new QSpinBox;
    box->setRange(min, max);
    box->setSuffix(suffix);
    box->setAccessibleName(name);
    return box;
}

QDoubleSpinBox* createNumberField(double min, double max, const QString& suffix, const QString& tip) {
    auto* box = new QDoubleSpinBox;
    box->setRange(min, max);
    box->setDecimals(2);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(suffix);
    box->setToolTip(tip);
    return box;
}

QString withoutFilmSuffix(const QString& path) {
    if (!isFilmPath(toPath(path))) return path;
    return path.left(path.lastIndexOf('.'));
}

}  // namespace

FilmDialog::FilmDialog(const FilmSubject& subject, QWidget* parent)
    : QDialog(parent), m_subject(subject), m_hasFfmpeg(findFfmpeg().has_value()) {
    setWindowTitle(tr("Export Film"));
    auto* form = new QFormLayout(this);
    addTarget(*form);
    addFrames(*form);
    addTime(*form);
    m_summary = new QLabel;
    m_summary->setObjectName("film-summary");
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    form->addRow(m_summary);
    addButtons(*form);
    restoreOptions();
    connectFields();
    updateSummary();
    resize(sizeHint().expandedTo({kMinFilmDialogWidth, 0}));
}

void FilmDialog::addTarget(QFormLayout& form) {
    m_kind = comboBox({tr("Film (MP4)"), tr("Numbered images (PNG)")}, tr("Select the output format"));
    form.addRow(tr("F&ormat:"), m_kind);
    if (!m_hasFfmpeg) {
        m_kind->setEnabled(false);
        auto* note = new QLabel(tr("Films need ffmpeg, which is not installed. Install it, or export images instead."));
        note->setObjectName("film-without-ffmpeg");
        note->setWordWrap(true);
        form.addRow(QString(), note);
    }
    m_path = new QLineEdit;
    m_path->setObjectName("film-path");
    m_path->setToolTip(tr("Set the file of the film or the folder for the images"));
    form.addRow(createLabel(tr("&Target:"), m_path), createPathRow(*m_path, [this] { browse(); }));
}

void FilmDialog::addFrames(QFormLayout& form) {
    m_width = createIntegerField(kMinImageSide, kMaxImageSide, tr(" px"), tr("Width"));
    m_height = createIntegerField(kMinImageSide, kMaxImageSide, tr(" px"), tr("Height"));
    auto* row = createRow({m_width, new QLabel("×"), m_height});
    row->addStretch(1);
    form.addRow(createLabel(tr("&Size:"), m_width), row);
    m_quality = comboBox({tr("As in the 3D view"), tr("Soft light"), tr("Softest light (slow)")},
                         tr("Select the quality of light and edges"));
    form.addRow(tr("&Quality:"), m_quality);
    m_compare = new QCheckBox(tr("&Compare without destruction"));
    m_compare->setToolTip(tr("Show the same simulation without destruction on the left"));
    form.addRow(QString(), m_compare);
}

void FilmDialog::addTime(QFormLayout& form) {
    const int length = static_cast<int>(std::min<std::uint64_t>(m_subject.length, 1'000'000'000));
    m_first = createIntegerField(0, length, {}, tr("First step"));
    m_last = createIntegerField(0, length, {}, tr("Last step"));
    m_last->setValue(length);
    auto* row = createRow({m_first, new QLabel(tr("to")), m_last});
    row->addStretch(1);
    form.addRow(createLabel(tr("St&eps:"), m_first), row);
    const NumberRange& rates = rangeOf(ProjectNumber::FrameRate);
    m_frameRate = createNumberField(rates.min, rates.max, tr(" frames per second"),
                                    tr("Set the frame rate; 24 to 60 look smooth"));
    form.addRow(tr("Frame &rate:"), m_frameRate);
    m_speed = createNumberField(0.01, 100.0, tr("×"), tr("Set the playback speed; values below 1 give slow motion"));
    m_speed->setValue(m_subject.speed);
    form.addRow(tr("S&peed:"), m_speed);
}

void FilmDialog::addButtons(QFormLayout& form) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form.addRow(buttons);
    m_export->setDefault(true);  // after the button was added to the dialog
}

void FilmDialog::connectFields() {
    connect(m_kind, &QComboBox::currentIndexChanged, this, &FilmDialog::updateSuffix);
    connect(m_path, &QLineEdit::textChanged, this, &FilmDialog::updateSummary);
    connect(m_compare, &QCheckBox::toggled, this, &FilmDialog::updateSummary);
    for (QSpinBox* box : {m_width, m_height, m_first, m_last}) {
        connect(box, &QSpinBox::valueChanged, this, &FilmDialog::updateSummary);
    }
    for (QDoubleSpinBox* box : {m_frameRate, m_speed}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &FilmDialog::updateSummary);
    }
}

/// Shows the options of the last film.
void FilmDialog::restoreOptions() {
    const QSettings settings;
    m_kind->setCurrentIndex(m_hasFfmpeg ? settings.value("film/pictures", 0).toInt() : 1);
    m_width->setValue(settings.value("film/width", 1280).toInt());
    m_height->setValue(settings.value("film/height", 720).toInt());
    m_quality->setCurrentIndex(settings.value("film/quality", 1).toInt());
    m_frameRate->setValue(settings.value("film/rate", 30.0).toDouble());
    const QString folder = pathOf(settings.value("film/folder"));
    const bool exists = is_directory(statusOf(folder));
    const QString path = unusedPath(exists ? folder : m_subject.folder, tr("%1 film").arg(m_subject.name), kFilmSuffix);
    m_path->setText(QDir::toNativeSeparators(path));
    updateSuffix();
}

FilmOptions FilmDialog::options() const {
    FilmOptions options{.path = QDir::fromNativeSeparators(m_path->text()),
                        .isFilm = m_kind->currentIndex() == 0,
                        .size = {m_width->value(), m_height->value()},
                        .samples = kSamples[m_quality->currentIndex()],
                        .frameRate = m_frameRate->value(),
                        .speed = m_speed->value(),
                        .first = static_cast<std::uint64_t>(m_first->value()),
                        .last = static_cast<std::uint64_t>(m_last->value()),
                        .isCompared = m_compare->isChecked()};
    if (options.isFilm && !options.path.isEmpty() && !isFilmPath(toPath(options.path))) options.path += kFilmSuffix;
    return options;
}

void FilmDialog::accept() {
    const FilmOptions accepted = options();
    QSettings settings;
    settings.setValue("film/pictures", m_kind->currentIndex());
    settings.setValue("film/width", accepted.size.width);
    settings.setValue("film/height", accepted.size.height);
    settings.setValue("film/quality", m_quality->currentIndex());
    settings.setValue("film/rate", accepted.frameRate);
    settings.setValue("film/folder", settingOf(QFileInfo(accepted.path).absolutePath()));
    QDialog::accept();
}

void FilmDialog::updateSuffix() {
    const QString base = withoutFilmSuffix(m_path->text());
    m_path->setText(m_kind->currentIndex() == 0 ? base + kFilmSuffix : base);
    updateSummary();
}

void FilmDialog::browse() {
    const QString title = windowTitle();
    const QString path =
        m_kind->currentIndex() == 0
            ? QFileDialog::getSaveFileName(this, title, m_path->text(), tr("Films (*.mp4 *.mkv *.mov *.webm)"))
            : QFileDialog::getExistingDirectory(this, title, QFileInfo(m_path->text()).path());
    if (!path.isEmpty()) m_path->setText(QDir::toNativeSeparators(path));
}

/// Shows what will be written, or what is wrong with the options.
void FilmDialog::updateSummary() {
    m_first->setMaximum(m_last->value());
    m_last->setMinimum(m_first->value());
    const FilmOptions current = options();
    const int frames = frameCount(static_cast<double>(current.first), static_cast<double>(current.last),
                                  current.stepsPerFrame(m_subject.stepLength));
    const QString wrong = error(current, frames);
    m_summary->setText(wrong.isEmpty() ? summary(current, frames) : wrong);
    m_export->setEnabled(wrong.isEmpty());
}

QString FilmDialog::error(const FilmOptions& options, int frames) const {
    if (options.path.isEmpty()) return tr("The target is empty. Enter a path.");
    if (!options.isFilm && isFilmPath(toPath(options.path)))
        return tr("The target is a file. Enter a folder for the images.");
    if (frames <= kMaxPictures) return {};
    return tr("The film would have %L1 frames; at most %L2 are possible. Use fewer steps, a lower frame rate or a "
              "higher speed.")
        .arg(frames)
        .arg(kMaxPictures);
}

QString FilmDialog::summary(const FilmOptions& options, int frames) const {
    const auto seconds = [](double time) { return QLocale().toString(time, 'f', 1); };
    const double simulated = static_cast<double>(options.last - options.first) * m_subject.stepLength;
    QString text = tr("%Ln frame(s): %1 s of film from %2 s of simulation.", nullptr, frames)
                       .arg(seconds(static_cast<double>(frames) / options.frameRate), seconds(simulated));
    if (options.isFilm && exists(statusOf(options.path))) {
        text += ' ' + tr("%1 will be replaced.").arg(fileNameText(options.path));
    }
    return text;
}

}  // namespace rubble

#include "moc_FilmDialog.cpp"
