// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopeexport.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMimeData>
#include <utility>

#include "widgets/common/filedialog.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopepicture.h"
#include "widgets/scope/scopestrips.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

/// More of them are for a file.
constexpr std::uint64_t kMostForClipboard = 5'000;

class Scope {
    Q_DECLARE_TR_FUNCTIONS(Scope)
};

using Seen = std::shared_ptr<const History>;

Seen seenOf(const ScopeStrips& strips, const History& history) {
    const TimePoint zero = history.zero().value_or(TimePoint{});
    return std::make_shared<const History>(
        history.cut(zero + fromSeconds(strips.time().left()), zero + fromSeconds(strips.time().right())));
}

FileContent contentOf(const Seen& seen, const std::vector<ScopeModule>& modules, const ScopeOrigin& origin) {
    const RecordingHeader header = recordingHeader(modules, origin.port, origin.simulated,
                                                   seen->zero().value_or(TimePoint{}), origin.zero);
    return [seen, header] { return recordingOf(header, *seen); };
}

std::uint64_t samplesIn(const History& history) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < history.modules(); ++i)
        count += history.module(ModuleIndex(static_cast<std::uint8_t>(i)))->count();
    return count;
}

QStringList captionOf(const ScopeOrigin& origin, const QString& title, double left) {
    const QString program = Scope::tr("NMC Panel %1").arg(QCoreApplication::applicationVersion()).trimmed();
    QStringList words{title.isEmpty() ? program : Scope::tr("%1, by %2").arg(title, program)};
    words << texts::portName(origin.port);
    if (origin.simulated)
        words << Scope::tr("SIMULATOR, no real motor moved");
    words.removeAll(QString());
    QStringList lines{words.join(u" · "_s)};
    if (origin.zero.isValid())
        lines << Scope::tr("From %1; 0 s is %2")
                     .arg(isoDate(origin.zero.addMSecs(qRound64(left * 1e3))), isoDate(origin.zero));
    return lines;
}

std::string pngOf(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes.toStdString();
}

}  // namespace

ScopeExport::ScopeExport(QWidget* panel) : QObject(panel), m_panel(panel), m_menu(new QMenu(panel)) {
    m_menu->setTitle(tr("Export"));
    m_menu->setToolTipsVisible(true);
    look::name(m_menu, u"scopeExportMenu"_s, tr("Export"));
    addAction(Kind::Csv, u"scopeExportCsvAction"_s, tr("&Samples (CSV)…"),
              tr("Every sample of all modules in the time that is seen, to be opened here again."));
    addAction(Kind::Png, u"scopeExportPngAction"_s, tr("&Picture (PNG)…"), tr("What is seen, as an image."));
    addAction(Kind::Svg, u"scopeExportSvgAction"_s, tr("&Vector picture (SVG)…"),
              tr("What is seen, in lines that stay sharp at any size."));
    addAction(Kind::Clipboard, u"scopeCopyAction"_s, tr("&Copy picture"),
              tr("What is seen, onto the clipboard; with its samples where these are few."));
}

void ScopeExport::addAction(Kind kind, const QString& objectName, const QString& text,
                            const QString& meaning) {
    QAction* action = m_menu->addAction(text);
    action->setObjectName(objectName);
    action->setToolTip(meaning);
    connect(action, &QAction::triggered, this, [this, kind] { choose(kind); });
}

void ScopeExport::choose(Kind kind) {
    if (kind == Kind::Clipboard)
        return want({kind});
    const QString suffix = kind == Kind::Csv ? u"csv"_s : kind == Kind::Png ? u"png"_s : u"svg"_s;
    QFileDialog* dialog =
        newFileDialog(m_panel, u"scopeExport%1Dialog"_s.arg(suffix), tr("Export from the scope"),
                      {tr("%1 files (*.%2)").arg(suffix.toUpper(), suffix), tr("All files (*)")}, m_folder);
    if (dialog == nullptr)
        return;
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->selectFile(tr("scope"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, kind](const QString& path) {
        m_folder = QFileInfo(path).absolutePath();
        want({kind, path});
    });
    dialog->show();
}

void ScopeExport::want(const Wanted& wanted) {
    m_wanted = wanted;
    emit frameWanted();
}

void ScopeExport::take(ScopeStrips& strips, const History& history, const ScopeOrigin& origin,
                       const QString& title) {
    if (!m_wanted)
        return;
    const Wanted wanted = *std::exchange(m_wanted, std::nullopt);
    const QStringList caption = captionOf(origin, title, strips.time().left());
    switch (wanted.kind) {
        case Kind::Csv:
            emit saveRequested(wanted.path, contentOf(seenOf(strips, history), strips.modules(), origin));
            break;
        case Kind::Png:
            emit saveRequested(wanted.path, [image = scopeImage(strips, caption)] { return pngOf(image); });
            break;
        case Kind::Svg:
            emit saveRequested(wanted.path, [svg = scopeSvg(strips, caption)] { return svg.toStdString(); });
            break;
        case Kind::Clipboard:
            copy(strips, caption, seenOf(strips, history), origin);
            break;
    }
}

void ScopeExport::copy(ScopeStrips& strips, const QStringList& caption,
                       const std::shared_ptr<const History>& seen, const ScopeOrigin& origin) {
    auto* data = new QMimeData;
    data->setImageData(scopeImage(strips, caption));
    if (samplesIn(*seen) <= kMostForClipboard)
        data->setData(u"text/csv"_s, QByteArray::fromStdString(contentOf(seen, strips.modules(), origin)()));
    QGuiApplication::clipboard()->setMimeData(data);
}

}  // namespace nmc
