#include "editor/FilmDialog.h"

#include "core/io/FilmFile.h"
#include "core/io/PictureSequence.h"
#include "editor/ChoiceBox.h"
#include "viewport/film/Film.h"
#include "viewport/render/Picture.h"

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

constexpr int kSamples[] = {0, 8, 32};  // of the qualities that are offered
constexpr const char* kFilmSuffix = ".mp4";
constexpr int kLeastWidth = 480;  // pixels: room for a path

QHBoxLayout* inARow(const QList<QWidget*>& widgets) {
    auto* row = new QHBoxLayout;
    for (QWidget* widget : widgets) row->addWidget(widget);
    return row;
}

QSpinBox* wholeNumber(int least, int most, const QString& suffix, const QString& name) {
    auto* box = new QSpinBox;
    box->setRange(least, most);
    box->setSuffix(suffix);
    box->setAccessibleName(name);
    return box;
}

QDoubleSpinBox* number(double least, double most, const QString& suffix, const QString& tip) {
    auto* box = new QDoubleSpinBox;
    box->setRange(least, most);
    box->setDecimals(2);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(suffix);
    box->setToolTip(tip);
    return box;
}

/// A path without a film's suffix.
QString withoutSuffix(const QString& path) {
    if (!isFilmPath(path.toStdString())) return path;
    return path.left(path.lastIndexOf('.'));
}

/// "house film", or with a number where that is taken.
QString freePlace(const QString& folder, const QString& name) {
    const QString base = QDir(folder).filePath(FilmDialog::tr("%1 film").arg(name));
    QString place = base;
    for (int k = 2; QFileInfo::exists(place) || QFileInfo::exists(place + kFilmSuffix); ++k) {
        place = QString("%1 %2").arg(base).arg(k);
    }
    return place;
}

}  // namespace

FilmDialog::FilmDialog(const FilmSubject& subject, QWidget* parent)
    : QDialog(parent), m_subject(subject), m_hasFfmpeg(ffmpegProgram().has_value()) {
    setWindowTitle(tr("Export Film"));
    auto* form = new QFormLayout(this);
    makePlace(*form);
    makePictures(*form);
    makeTime(*form);
    m_summary = new QLabel;
    m_summary->setObjectName("film-summary");
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    form->addRow(m_summary);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
    m_export->setDefault(true);  // a button knows its dialog only now
    fill();
    connect(m_kind, &QComboBox::currentIndexChanged, this, &FilmDialog::takeKind);
    connect(m_place, &QLineEdit::textChanged, this, &FilmDialog::update);
    connect(m_compare, &QCheckBox::toggled, this, &FilmDialog::update);
    for (QSpinBox* box : {m_width, m_height, m_first, m_last}) {
        connect(box, &QSpinBox::valueChanged, this, &FilmDialog::update);
    }
    for (QDoubleSpinBox* box : {m_rate, m_speed}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &FilmDialog::update);
    }
    update();
    resize(sizeHint().expandedTo({kLeastWidth, 0}));
}

void FilmDialog::makePlace(QFormLayout& form) {
    m_kind = choiceBox({tr("A film (MP4)"), tr("Pictures (PNG), numbered")}, tr("What is written"));
    form.addRow(tr("&Write:"), m_kind);
    if (!m_hasFfmpeg) {
        m_kind->setEnabled(false);
        auto* note =
            new QLabel(tr("There is no ffmpeg on this machine to make a film with. The pictures can be made into one "
                          "elsewhere."));
        note->setObjectName("film-without-ffmpeg");
        note->setWordWrap(true);
        form.addRow(QString(), note);
    }
    m_place = new QLineEdit;
    m_place->setObjectName("film-place");
    m_place->setToolTip(tr("The film's file, or the folder that its pictures go into"));
    auto* browse = new QPushButton(tr("Browse…"));
    connect(browse, &QPushButton::clicked, this, &FilmDialog::browse);
    auto* row = inARow({m_place, browse});
    row->setStretch(0, 1);
    auto* label = new QLabel(tr("&To:"));
    label->setBuddy(m_place);
    form.addRow(label, row);
}

void FilmDialog::makePictures(QFormLayout& form) {
    m_width = wholeNumber(16, kLargestPicture, tr(" px"), tr("Width"));
    m_height = wholeNumber(16, kLargestPicture, tr(" px"), tr("Height"));
    auto* row = inARow({m_width, new QLabel("×"), m_height});
    row->addStretch(1);
    auto* label = new QLabel(tr("&Size:"));
    label->setBuddy(m_width);
    form.addRow(label, row);
    m_quality = choiceBox({tr("As in the view"), tr("Soft light"), tr("Softest light, slow")},
                          tr("How long light and edges of each picture are worked at"));
    form.addRow(tr("&Quality:"), m_quality);
    m_compare = new QCheckBox(tr("&Beside it the same without destruction"));
    m_compare->setToolTip(tr("Nothing breaks on the left, and all that is hit hard enough does on the right"));
    form.addRow(QString(), m_compare);
}

void FilmDialog::makeTime(QFormLayout& form) {
    const int length = static_cast<int>(std::min<std::uint64_t>(m_subject.length, 1'000'000'000));
    m_first = wholeNumber(0, length, {}, tr("First step"));
    m_last = wholeNumber(0, length, {}, tr("Last step"));
    m_last->setValue(length);
    auto* row = inARow({m_first, new QLabel(tr("to")), m_last});
    row->addStretch(1);
    auto* label = new QLabel(tr("St&eps:"));
    label->setBuddy(m_first);
    form.addRow(label, row);
    m_rate = number(1.0, 240.0, tr(" pictures a second"), tr("Of the film; 24 to 60 look smooth"));
    form.addRow(tr("&Rate:"), m_rate);
    m_speed = number(0.01, 100.0, tr("×"), tr("Below 1 is slow motion: things are drawn between two steps, too"));
    m_speed->setValue(m_subject.speed);
    form.addRow(tr("S&peed:"), m_speed);
}

/// As the last film was.
void FilmDialog::fill() {
    const QSettings settings;
    m_kind->setCurrentIndex(m_hasFfmpeg ? settings.value("film/pictures", 0).toInt() : 1);
    m_width->setValue(settings.value("film/width", 1280).toInt());
    m_height->setValue(settings.value("film/height", 720).toInt());
    m_quality->setCurrentIndex(settings.value("film/quality", 1).toInt());
    m_rate->setValue(settings.value("film/rate", 30.0).toDouble());
    const QString folder = settings.value("film/folder").toString();
    const bool isThere = !folder.isEmpty() && QFileInfo(folder).isDir();
    m_place->setText(QDir::toNativeSeparators(freePlace(isThere ? folder : m_subject.folder, m_subject.name)));
    takeKind();
}

FilmChoice FilmDialog::choice() const {
    FilmChoice choice{.place = QDir::fromNativeSeparators(m_place->text()),
                      .isFilm = m_kind->currentIndex() == 0,
                      .size = {m_width->value(), m_height->value()},
                      .samples = kSamples[m_quality->currentIndex()],
                      .rate = m_rate->value(),
                      .speed = m_speed->value(),
                      .first = static_cast<std::uint64_t>(m_first->value()),
                      .last = static_cast<std::uint64_t>(m_last->value()),
                      .isCompared = m_compare->isChecked()};
    if (choice.isFilm && !choice.place.isEmpty() && !isFilmPath(choice.place.toStdString()))
        choice.place += kFilmSuffix;
    return choice;
}

void FilmDialog::accept() {
    const FilmChoice chosen = choice();
    QSettings settings;
    settings.setValue("film/pictures", m_kind->currentIndex());
    settings.setValue("film/width", chosen.size.width);
    settings.setValue("film/height", chosen.size.height);
    settings.setValue("film/quality", m_quality->currentIndex());
    settings.setValue("film/rate", chosen.rate);
    settings.setValue("film/folder", QFileInfo(chosen.place).absolutePath());
    QDialog::accept();
}

void FilmDialog::takeKind() {
    const QString base = withoutSuffix(m_place->text());
    m_place->setText(m_kind->currentIndex() == 0 ? base + kFilmSuffix : base);
    update();
}

void FilmDialog::browse() {
    const QString title = windowTitle();
    const QString place =
        m_kind->currentIndex() == 0
            ? QFileDialog::getSaveFileName(this, title, m_place->text(), tr("Films (*.mp4 *.mkv *.mov *.webm)"))
            : QFileDialog::getExistingDirectory(this, title, QFileInfo(m_place->text()).path());
    if (!place.isEmpty()) m_place->setText(QDir::toNativeSeparators(place));
}

/// Says what will be written, or why it cannot be.
void FilmDialog::update() {
    m_first->setMaximum(m_last->value());
    m_last->setMinimum(m_first->value());
    const FilmChoice chosen = choice();
    const int pictures = picturesBetween(static_cast<double>(chosen.first), static_cast<double>(chosen.last),
                                         chosen.every(m_subject.stepLength));
    const QString wrong = fault(chosen, pictures);
    m_summary->setText(wrong.isEmpty() ? summary(chosen, pictures) : wrong);
    m_export->setEnabled(wrong.isEmpty());
}

QString FilmDialog::fault(const FilmChoice& choice, int pictures) const {
    if (choice.place.isEmpty()) return tr("Say where it is to be written.");
    if (!choice.isFilm && isFilmPath(choice.place.toStdString()))
        return tr("The pictures go into a folder, not a file.");
    if (pictures <= kMostPictures) return {};
    return tr("These are %L1 pictures; a film can have %L2. Take fewer steps, a lower rate or a higher speed.")
        .arg(pictures)
        .arg(kMostPictures);
}

QString FilmDialog::summary(const FilmChoice& choice, int pictures) const {
    const auto seconds = [](double time) { return QLocale().toString(time, 'f', 1); };
    const double played = static_cast<double>(choice.last - choice.first) * m_subject.stepLength;
    QString text = tr("%L1 pictures that show %2 s of play in %3 s.")
                       .arg(pictures)
                       .arg(seconds(played), seconds(static_cast<double>(pictures) / choice.rate));
    if (choice.isFilm && QFileInfo::exists(choice.place)) {
        text += ' ' + tr("%1 is there already and will be replaced.").arg(QFileInfo(choice.place).fileName());
    }
    return text;
}

}  // namespace rubble
