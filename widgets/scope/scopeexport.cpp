// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopeexport.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMimeData>
#include <algorithm>
#include <utility>

#include "model/recording/widerecording.h"
#include "widgets/common/dates.h"
#include "widgets/common/look.h"
#include "widgets/common/picture.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopestrips.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

/// Larger numbers of samples are exported only to a file.
constexpr std::uint64_t kMaxForClipboard = 5'000;

enum Form { Long, Sparse, Even };

struct SeenHistory {
    std::shared_ptr<const History> history;  ///< complete for a wide form, to derive signals
    TimePoint from, to;
    std::optional<TimePoint> coarserBefore;
};

/// The time before which some module's samples, though visible, are kept only in a coarser form.
std::optional<TimePoint> coarserBefore(const History& history, TimePoint left) {
    std::optional<TimePoint> latest;
    for (std::size_t i = 0; i < history.modules(); ++i) {
        const ModuleHistory& module = *history.module(ModuleIndex(static_cast<std::uint8_t>(i)));
        if (const auto kept = module.keptSince(); kept && *kept > left && *module.begin() < *kept)
            latest = std::max(latest.value_or(*kept), *kept);
    }
    return latest;
}

SeenHistory seenBetween(TimePoint from, TimePoint to, const History& history, int form = Long) {
    return {std::make_shared<const History>(form == Long ? history.cut(from, to) : history), from, to,
            coarserBefore(history, from)};
}

SeenHistory seenOf(const ScopeStrips& strips, const History& history, int form = Long) {
    const TimePoint zero = history.zero().value_or(TimePoint{});
    return seenBetween(zero + fromSeconds(strips.time().left()), zero + fromSeconds(strips.time().right()),
                       history, form);
}

/// In the order of Form.
QStringList csvForms() {
    return {ScopeTexts::tr("One row per reply, can be reopened here (*.csv)"),
            ScopeTexts::tr("One column per signal, for other programs only (*.csv)"),
            ScopeTexts::tr("One column per signal, every millisecond, for other programs only (*.csv)")};
}

/// Only the long form can be opened here again; the panel says so when another one is opened
/// (recordingtexts.cpp).
FileContent contentOf(const SeenHistory& seen, const std::vector<ScopeModule>& modules,
                      const ScopeOrigin& origin, int form = Long) {
    constexpr Duration kInterval = std::chrono::milliseconds(1);
    const RecordingHeader header = recordingHeader(modules, origin.port, origin.simulated,
                                                   seen.history->zero().value_or(TimePoint{}), origin.zero);
    if (form != Long)
        return [seen, header, interval = form == Even ? kInterval : Duration::zero()] {
            return wideRecordingOf(header, *seen.history, interval, seen.from, seen.to);
        };
    return [seen, header] {
        std::string text = recordingOf(header, *seen.history);
        if (seen.coarserBefore)
            appendNote(text, "not all samples before are in this file because they are not kept one by one",
                       *seen.coarserBefore, header.zero);
        return text;
    };
}

/// Returns empty text if there are too many samples for the clipboard.
std::string fewSamples(const SeenHistory& seen, const std::vector<ScopeModule>& modules,
                       const ScopeOrigin& origin) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < seen.history->modules(); ++i)
        count += seen.history->module(ModuleIndex(static_cast<std::uint8_t>(i)))->count();
    return count <= kMaxForClipboard ? contentOf(seen, modules, origin)() : std::string();
}

QStringList captionOf(const ScopeOrigin& origin, const QString& title, double left) {
    const QString program = Common::tr("NMC Panel %1").arg(QCoreApplication::applicationVersion()).trimmed();
    QStringList words{title.isEmpty() ? program : ScopeTexts::tr("%1, by %2").arg(title, program)};
    words << texts::portName(origin.port);
    if (origin.simulated)
        words << Common::tr("SIMULATOR, no real motor moved");
    words.removeAll(QString());
    QStringList lines{words.join(u" · "_s)};
    if (origin.zero.isValid())
        lines << ScopeTexts::tr("From %1; 0 s is %2")
                     .arg(isoDate(origin.zero.addMSecs(qRound64(left * 1e3))), isoDate(origin.zero));
    return lines;
}

}  // namespace

FileContent samplesBetween(TimePoint from, TimePoint to, const History& history,
                           const std::vector<ScopeModule>& modules, const ScopeOrigin& origin) {
    return contentOf(seenBetween(from, to, history), modules, origin);
}

ScopeExport::ScopeExport(Requests& requests, QWidget* panel)
    : QObject(panel), m_requests(requests), m_panel(panel), m_menu(new QMenu(panel)) {
    m_menu->setTitle(tr("Export"));
    m_menu->setToolTipsVisible(true);
    look::name(m_menu, u"scopeExportMenu"_s, tr("Export"));
    addAction(
        Kind::Csv, u"scopeExportCsvAction"_s, tr("&Samples (CSV)…"),
        tr("All samples of all modules in the visible time. A file with one row per reply can be reopened here; one with a column per signal is for other programs only."));
    addAction(Kind::Png, u"scopeExportPngAction"_s, Common::tr("&Picture (PNG)…"),
              Common::tr("The visible plot as an image."));
    addAction(Kind::Svg, u"scopeExportSvgAction"_s, Common::tr("&Vector picture (SVG)…"),
              Common::tr("The visible plot as lines that stay sharp at any size."));
    addAction(Kind::Pdf, u"scopeExportPdfAction"_s, Common::tr("P&age (PDF)…"),
              Common::tr("The visible plot on a page for printing or a report."));
    m_menu->addSeparator();
    addAction(Kind::Clipboard, u"scopeCopyAction"_s, Common::tr("&Copy picture"),
              tr("Copies the visible plot to the clipboard, with its samples if there are only a few."));
    addAction(Kind::Printer, u"scopePrintAction"_s, Common::tr("P&rint…"),
              Common::tr("Prints the visible plot on one of this computer's printers."));
}

void ScopeExport::addAction(Kind kind, const QString& objectName, const QString& text,
                            const QString& meaning) {
    QAction* action = m_menu->addAction(text);
    action->setObjectName(objectName);
    action->setToolTip(meaning);
    connect(action, &QAction::triggered, this, [this, kind] { choose(kind); });
}

void ScopeExport::choose(Kind kind) {
    if (kind == Kind::Clipboard || kind == Kind::Printer)
        return want({kind});
    const QString suffix = kind == Kind::Csv   ? u"csv"_s
                           : kind == Kind::Png ? u"png"_s
                           : kind == Kind::Svg ? u"svg"_s
                                               : u"pdf"_s;
    const QStringList filters = kind == Kind::Csv
                                    ? csvForms()
                                    : QStringList{Common::tr("%1 files (*.%2)").arg(suffix.toUpper(), suffix),
                                                  Common::tr("All files (*)")};
    QFileDialog* dialog = newSaveDialog(
        m_panel,
        {u"scopeExport%1Dialog"_s.arg(suffix), tr("Export from the scope"), filters, m_folder, tr("scope")});
    if (dialog == nullptr)
        return;
    connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, kind, suffix](const QString& path) {
        m_folder = QFileInfo(path).absolutePath();
        const auto form = static_cast<int>(csvForms().indexOf(dialog->selectedNameFilter()));
        want({kind, path, suffix, std::max(0, form)});
    });
    dialog->show();
}

void ScopeExport::want(const Wanted& wanted) {
    m_wanted = wanted;
    emit frameWanted();
}

void ScopeExport::take(ScopeStrips& strips, const History& history, double now, const ScopeOrigin& origin,
                       const QString& title) {
    if (!m_wanted)
        return;
    const Wanted wanted = *std::exchange(m_wanted, std::nullopt);
    const Picture picture{&strips, captionOf(origin, title, strips.time().left()), [&](QPainter& painter) {
                              strips.showFrame(history, now, kSharpness);
                              strips.showFrame(history, now, kSharpness);  // the first one finds the margins
                              strips.renderTo(painter);
                          }};
    switch (wanted.kind) {
        case Kind::Csv:
            emit m_requests.save(wanted.path, contentOf(seenOf(strips, history, wanted.form),
                                                        strips.modules(), origin, wanted.form));
            break;
        case Kind::Png:
        case Kind::Svg:
        case Kind::Pdf:
            emit m_requests.save(wanted.path, fileOf(picture, wanted.suffix));
            break;
        case Kind::Printer:
            emit m_requests.print(pdfOf(picture));
            break;
        case Kind::Clipboard:
            copy(imageOf(picture), fewSamples(seenOf(strips, history), strips.modules(), origin));
            break;
    }
    strips.showFrame(history, now);  // with the sharpness of the screen
}

void ScopeExport::copy(const QImage& image, const std::string& samples) {
    auto* data = new QMimeData;
    data->setImageData(image);
    if (!samples.empty())
        data->setData(u"text/csv"_s, QByteArray::fromStdString(samples));
    QGuiApplication::clipboard()->setMimeData(data);
}

}  // namespace nmc
