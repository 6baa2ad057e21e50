// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machinecontroller.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "link/files/machineio.h"
#include "model/intent/rights.h"
#include "model/machinefile/axisremoval.h"
#include "model/machinefile/machinegroups.h"
#include "widgets/common/texts.h"
#include "widgets/machine/machinemenu.h"
#include "widgets/sequences/sequencesdock.h"

namespace nmc {

namespace {

/// Delay between a change and storing it.
constexpr int kKeepUnsavedAfterMs = 3'000;
constexpr qsizetype kRecentFiles = 8;
const QString kRecent = QStringLiteral("machine/recent");
/// The machine in operator mode: its file, the hash of what is in there, the whole machine, and whether it
/// has unsaved changes. It is kept beside the lock itself, so that the mode never goes on without it.
const QString kOperatorMachine = QStringLiteral("machine/operator");
constexpr int kOperatorParts = 4;

QString folderOr(const QString& folder, const QSettings& settings) {
    return folder.isEmpty() ? QFileInfo(settings.fileName()).absoluteDir().filePath(QStringLiteral("unsaved"))
                            : folder;
}

QString hashOf(const std::string& text) {
    const auto bytes = QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size()));
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

/// The text to write, unless someone else has changed the file, who must not lose that. Runs in another
/// thread.
tl::expected<std::string, FileError> replacing(const QString& before, const QString& path,
                                               const std::string& text) {
    if (before.isEmpty())
        return text;
    const auto now = readFile(path, kMaxMachineFile);
    if (now && hashOf(*now) != before)
        return tl::unexpected(FileError{FileErrorKind::ChangedElsewhere, path});
    if (!now && now.error().trouble != FileErrorKind::NotThere)
        return tl::unexpected(now.error());
    return text;
}

}  // namespace

MachineController::MachineController(QSettings& settings, MainWindow& window, const BusStore& store,
                                     const QString& unsavedFolder, const FileWriter::Disk& disk)
    : m_settings(settings),
      m_window(window),
      m_store(store),
      m_unsaved(folderOr(unsavedFolder, settings), disk),
      m_files(disk) {
    m_keepTimer.setSingleShot(true);
    m_keepTimer.setInterval(kKeepUnsavedAfterMs);
    connect(&m_keepTimer, &QTimer::timeout, this, &MachineController::keepUnsaved);
    MachineMenu& menu = m_window.machineMenu();
    connect(&menu, &MachineMenu::newRequested, this, &MachineController::beginNew);
    connect(&menu, &MachineMenu::openRequested, this, &MachineController::open);
    connect(&menu, &MachineMenu::saveRequested, this, [this] { save(m_path, m_inFile); });
    // Who chooses a file that exists has agreed to replace it.
    connect(&menu, &MachineMenu::saveAsRequested, this, [this](const QString& path) { save(path, {}); });
    connect(&menu, &MachineMenu::applyRequested, this, &MachineController::apply);
    connect(&menu, &MachineMenu::differencesDropped, this, [this] { m_pending.reset(); });
    connect(&m_store, &BusStore::linkChanged, this, &MachineController::followLink);
}

MachineController::~MachineController() {
    keepUnsaved();
}

/// An operator may neither restore nor open anything, and must not work with an empty machine instead of the
/// one with which operator mode was left: its axes would count otherwise, and have no travel limits.
void MachineController::start(const std::optional<QString>& file) {
    m_window.showMachine(m_machine);
    showFile();
    emit taken(m_path);
    if (file)
        openAtStart(QFileInfo(*file).absoluteFilePath());
    if (locked() && m_machine == Machine{})
        goOnInOperatorMode();
    if (!m_unsaved.left() || m_restored)
        return;
    if (const auto work = leftWork(); !work)
        m_window.showMessage(texts::unsavedWorkDamaged(work.error()));
    else
        m_window.showMessage(texts::unsavedWorkLeft(
            MachineFile{work->path, QString::fromStdString(work->content.machine.name), true, {}}.title()));
}

void MachineController::goOnInOperatorMode() {
    const QStringList kept = m_settings.value(kOperatorMachine).toStringList();
    if (kept.size() != kOperatorParts)
        return;
    const QString& file = kept[0];
    const bool isSaved = kept[3].isEmpty();
    if (isSaved && !file.isEmpty())
        openAtStart(file);  // someone may have changed it
    const std::string text = kept[2].toStdString();
    const auto content = parseMachine(text);
    if (m_machine != Machine{} || !content || content->machine == Machine{})
        return;
    const auto& left = m_unsaved.left();
    Pending work{file, *content, left && left->file == file && left->content == text, {}, {}, kept[1]};
    take(work, work.content.machine, true);
    if (!isSaved && !work.restored) {
        m_saved.reset();
        changed();
    }
}

void MachineController::keepForOperator() {
    m_settings.setValue(
        kOperatorMachine,
        QStringList{m_path, m_inFile, QString::fromStdString(writeMachine(m_machine, m_unknown)),
                    modified() ? QStringLiteral("modified") : QString()});
}

bool MachineController::locked() const {
    return whyNotEdited(m_store.link().rights).has_value();
}

void MachineController::edit(ModuleIndex module, const AxisSettings& settings) {
    if (locked())
        return;
    Machine edited = m_machine;
    if (edited.axes.size() <= module.value())
        edited.axes.resize(module.value() + std::size_t{1});
    edited.axes[module.value()] = settings;
    changeAxes(std::move(edited));
}

void MachineController::changeAxes(Machine edited) {
    const bool nothingExpected =
        std::ranges::none_of(edited.axes, [](const AxisSettings& axis) { return axis.expected.has_value(); });
    const Machine before = std::exchange(m_machine, std::move(edited));
    if (nothingExpected && !chain().empty())
        return acceptChain(chain());
    m_machine = forModules(chain(), before, std::move(m_machine));
    changed();
}

void MachineController::editProgram(const Program& program) {
    if (locked())
        return;
    Machine edited = m_machine;
    edited.program = program;
    changeAxes(std::move(edited));
}

void MachineController::editHomeOrder(const std::vector<ModuleIndex>& order) {
    if (locked())
        return;
    m_machine.homeOrder = order;
    changed();
}

void MachineController::noteSent(ModuleIndex module, const Intent& intent) {
    AxisSettings axis = m_machine.axis(module);
    if (const auto* apply = std::get_if<intent::ApplyGains>(&intent))
        axis.gains = apply->gains;
    else if (const auto* control = std::get_if<intent::ControlIo>(&intent))
        axis.io = control->io;
    else if (const auto* amplifier = std::get_if<intent::ControlSc>(&intent))
        axis.fastPath = amplifier->io.fastPath;
    else if (const auto* set = std::get_if<stepperintent::SetParameters>(&intent))
        axis.parameters = set->parameters;
    if (axis != m_machine.axis(module))
        edit(module, axis);
}

void MachineController::noteGroup(const bus::GroupChange& change) {
    nmc::noteGroup(m_machine, change);
    changed();
}

void MachineController::nameGroup(quint8 group, const QString& name) {
    if (locked())
        return;
    nmc::nameGroup(m_machine, group, name.toStdString());
    changed();
}

void MachineController::setOperatorRights(const OperatorRights& rights) {
    if (rights != m_machine.operatorRights.value_or(OperatorRights{})) {
        m_machine.operatorRights = rights;
        changed();
    }
    keepForOperator();
}

void MachineController::acceptChain(const std::vector<ModuleIdentity>& there,
                                    const std::vector<ModuleIndex>& gone) {
    if (!gone.empty()) {
        ParsedMachine left = withoutAxes(gone, {std::move(m_machine), std::move(m_unknown)});
        m_machine = std::move(left.machine);
        m_unknown = std::move(left.unknown);
        if (SequencesPage* page = m_window.sequences().builtPage())
            page->forgetEdits();
    }
    m_machine = withModules(there, std::move(m_machine));
    changed();
}

void MachineController::beginNew() {
    if (locked())
        return;
    m_machine = {};
    m_saved = Machine{};
    m_unknown = {};
    m_path.clear();
    m_inFile.clear();
    m_saving.clear();
    changed();
    emit taken(m_path);
}

std::optional<MachineController::Pending> MachineController::read(const QString& path) {
    const auto text = readFile(path, kMaxMachineFile);
    if (!text) {
        m_window.showMessage(texts::machineNotOpened(text.error()));
        return std::nullopt;
    }
    auto content = parseMachine(*text);
    if (!content) {
        m_window.showMessage(texts::machineNotOpened(path, content.error()));
        return std::nullopt;
    }
    m_window.endMessage(texts::key::kMachineFile);
    return Pending{path, std::move(*content), false, {}, {}, hashOf(*text)};
}

void MachineController::open(const QString& path) {
    if (locked())
        return;  // the file dialog was open when operator mode began
    if (auto file = read(path)) {
        m_pending = std::move(file);
        showPending();
    }
}

/// An operator may not choose what to apply, and works with the whole machine or with none. Nothing is
/// connected yet, so nothing is sent.
void MachineController::openAtStart(const QString& path) {
    if (!locked())
        return open(path);
    if (const auto file = read(path))
        take(*file, file->content.machine, true);
}

void MachineController::restoreWork() {
    if (!m_unsaved.left() || locked())
        return;
    const auto work = leftWork();
    if (!work)
        return;
    if (m_machine == Machine{} && modules().empty()) {
        take(*work, work->content.machine, true);
        return;
    }
    m_pending = *work;
    showPending();
}

tl::expected<MachineController::Pending, FileProblem> MachineController::leftWork() const {
    auto content = parseMachine(m_unsaved.left()->content);
    if (!content)
        return tl::unexpected(content.error());
    return Pending{m_unsaved.left()->file, std::move(*content), true, {}, {}, m_unsaved.left()->fileHash};
}

void MachineController::copy(const AxisCopy& copy) {
    if (locked())
        return;
    if (copyDifferences(copy, m_machine, modules()).empty())
        return m_window.showMessage(texts::axisCopied(copy.from, 0, 0));
    m_pending = Pending{{}, {}, false, {}, copy};
    showPending();
}

std::vector<Difference> MachineController::differences() const {
    return m_pending->copy ? copyDifferences(*m_pending->copy, m_machine, modules())
                           : compare(m_pending->content.machine, m_machine, modules());
}

void MachineController::showPending() {
    m_pending->chain = chain();
    m_pending->shown = differences();
    if (m_pending->shown.empty()) {
        const Pending same = *std::exchange(m_pending, std::nullopt);
        m_window.machineMenu().closeDifferences();
        if (same.copy)
            return m_window.showMessage(texts::axisCopied(same.copy->from, 0, 0));
        take(same, applied(same.content.machine, m_machine, modules(), {}), true);
        m_window.showMessage(texts::machineSame(same.path));
        return;
    }
    if (m_pending->copy)
        m_window.machineMenu().showCopy(m_pending->copy->from, m_pending->shown);
    else
        m_window.machineMenu().showDifferences(m_pending->path, m_pending->shown);
    followLink();
}

void MachineController::apply(const std::vector<PartId>& chosen) {
    if (!m_pending || locked())
        return;
    // The user decided on what was shown; since then, a silent module may have answered, or a motor may have
    // been switched on.
    const std::vector<Difference> now = differences();
    if (!stillHold(m_pending->shown, now, chosen)) {
        showPending();
        if (m_pending)
            m_window.showMessage(texts::machineNotApplied(0));
        return;
    }
    const std::vector<ModuleState> present = modules();
    const Machine file =
        m_pending->copy ? withCopy(*m_pending->copy, m_machine, present) : m_pending->content.machine;
    const std::vector<ModuleIntent> intents = sendings(file, m_machine, present, chosen);
    Machine machine = applied(file, m_machine, present, chosen);
    std::vector<bus::GroupChange> groups;
    if (std::ranges::find(chosen, PartId{{}, MachinePart::Groups}) != chosen.end())
        groups = groupChanges(machine, present);
    const auto sent = static_cast<int>(intents.size() + groups.size());
    if (const int moving = m_store.movingMotors(); sent > 0 && moving > 0)
        return m_window.showMessage(texts::machineNotApplied(moving));
    const bool whole = std::ranges::find(now, Applying::OtherHardware, &Difference::applying) == now.end();
    const Pending from = *std::exchange(m_pending, std::nullopt);
    m_window.endMessage(texts::key::kNotApplied);
    m_window.machineMenu().closeDifferences();
    if (from.copy)
        changeAxes(std::move(machine));
    else
        take(from, std::move(machine), whole);
    for (const ModuleIntent& send : intents)
        emit intentRequested(send.module, send.intent);
    for (const bus::GroupChange& change : groups)
        emit groupChangeRequested(change);
    const int parts = static_cast<int>(chosen.size());
    m_window.showMessage(from.copy ? texts::axisCopied(from.copy->from, parts, sent)
                                   : texts::machineOpened(from.path, parts, sent));
}

/// A file that could not be applied as a whole does not become the present file, so that saving does not
/// overwrite it.
void MachineController::take(const Pending& from, Machine machine, bool whole) {
    m_machine = std::move(machine);
    m_unknown = from.content.unknown;
    m_path = whole ? from.path : QString();
    m_inFile = from.inFile;
    m_saving.clear();
    m_saved = whole && !from.restored ? std::optional(from.content.machine) : std::nullopt;
    if (!from.restored && !from.path.isEmpty())
        remember(from.path);
    changed();
    emit taken(m_path);
    if (!from.restored)
        return;
    m_restored = whole;
    keepUnsaved();
}

void MachineController::save(const QString& path, const QString& before) {
    Machine machine = withChain(m_machine, modules(), m_store.link().baud);
    if (machine.name.empty())
        machine.name = QFileInfo(path).completeBaseName().toStdString();
    const std::string text = writeMachine(machine, m_unknown);
    auto written = parseMachine(text);
    if (!written) {
        // The file could not be read again, so it must not replace one that can.
        m_window.showMessage(texts::machineNotSaved(path, written.error()));
        return;
    }
    m_saving = path;
    showFile();
    m_files.write(
        path, [before, path, text] { return replacing(before, path, text); },
        [this, path, asked = m_machine, text, written = std::move(*written)](
            const FileWriter::Result& result) { saved(path, asked, text, written, result); });
}

void MachineController::saved(const QString& path, const Machine& asked, const std::string& text,
                              const ParsedMachine& written, const FileWriter::Result& result) {
    // Otherwise another machine or another file has taken its place.
    const bool wanted = m_saving == path;
    if (wanted)
        m_saving.clear();
    if (!result) {
        m_window.showMessage(texts::machineNotSaved(result.error()));
        return showFile();
    }
    m_window.endMessage(texts::key::kMachineFile);
    // What a table of this file would apply is not in the file any more.
    if (m_pending && !m_pending->copy && !m_pending->restored &&
        QFileInfo(m_pending->path) == QFileInfo(path)) {
        m_pending.reset();
        m_window.machineMenu().closeDifferences();
    }
    // Or the same file, from a table that was applied in the meantime.
    if (!wanted && path != m_path)
        return showFile();
    // Edits made in the meantime are not in the file; those of axes moved the unknown keys as well.
    if (m_machine == asked) {
        m_machine = written.machine;
        m_unknown = written.unknown;
    }
    m_saved = written.machine;
    m_path = path;
    m_inFile = hashOf(text);
    remember(path);
    emit hasFile(m_path);
    changed();  // what waited for the save follows at once, which may be another machine
    keepUnsaved();
}

void MachineController::followLink() {
    if (!m_pending)
        return;
    // A different chain requires a new comparison; what was ticked applied to the previous one.
    if (m_pending->chain != chain() && m_pending->copy) {
        m_pending.reset();  // it was chosen for the axes of that chain
        m_window.machineMenu().closeDifferences();
    } else if (m_pending->chain != chain())
        showPending();
    else if (DifferencesDialog* dialog = m_window.machineMenu().differences())
        dialog->showMoving(m_store.movingMotors());
}

void MachineController::keepUnsaved() {
    m_keepTimer.stop();
    if (!modified()) {
        m_unsaved.forget();
        dropRestored();
        return;
    }
    m_unsaved.keep(m_path, m_inFile, writeMachine(m_machine, m_unknown),
                   [this](const FileWriter::Result& kept) {
                       if (kept)
                           dropRestored();
                       else if (!m_keepFailed)
                           m_window.showMessage(texts::unsavedWorkNotKept(kept.error()));
                       m_keepFailed = !kept;
                   });
}

void MachineController::dropRestored() {
    if (std::exchange(m_restored, false))
        m_unsaved.dropLeft();
}

void MachineController::changed() {
    if (!m_keepTimer.isActive())
        m_keepTimer.start();
    if (locked())
        keepForOperator();  // it may have been saved when the window was closed
    // The window must know this machine before the link's updates that follow.
    m_window.showMachine(m_machine);
    showFile();
    emit machineChanged();
}

void MachineController::showFile() {
    m_window.machineMenu().showFile({m_path, QString::fromStdString(m_machine.name), modified(),
                                     m_settings.value(kRecent).toStringList(), !m_saving.isEmpty()});
}

void MachineController::remember(const QString& path) {
    QStringList recent = m_settings.value(kRecent).toStringList();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    recent.removeAll(absolute);
    recent.prepend(absolute);
    m_settings.setValue(kRecent, recent.mid(0, kRecentFiles));
}

std::vector<ModuleState> MachineController::modules() const {
    return m_store.link().phase == LinkPhase::Connected ? m_store.link().modules : std::vector<ModuleState>{};
}

std::vector<ModuleIdentity> MachineController::chain() const {
    std::vector<ModuleIdentity> identities;
    for (const ModuleState& module : modules())
        identities.push_back(module.info.identity);
    return identities;
}

}  // namespace nmc
