// SPDX-License-Identifier: MIT
#include "link/files/unsavedwork.h"

#include <QDir>
#include <QFile>
#include <QLockFile>
#include <QUrl>

namespace nmc {

namespace {
/// The maximum number of programs that keep unsaved work at the same time.
constexpr int kSlots = 20;
/// The size of a machine file, preceded by its file name, and by the hash as the fragment of that URL.
constexpr std::size_t kMaxKept = 1'100'000;

std::optional<UnsavedWork::Left> workIn(const QString& path) {
    const auto content = readFile(path, kMaxKept);
    const std::size_t line = content ? content->find('\n') : std::string::npos;
    if (line == std::string::npos)
        return std::nullopt;
    const QUrl file(QString::fromStdString(content->substr(0, line)));
    return UnsavedWork::Left{file.toLocalFile(), file.fragment(), content->substr(line + 1)};
}
}  // namespace

UnsavedWork::UnsavedWork(const QString& folder, FileWriter::Disk disk)
    : m_folder(folder), m_files(std::move(disk)) {
    QDir().mkpath(m_folder);
    // One that cannot be read does not hide those behind it.
    for (int number = 1; number <= kSlots && !m_left; ++number)
        if (auto slot = takeSlot(number, Wanted::Used); slot && (m_left = workIn(slot->path)))
            m_leftSlot = std::move(slot);
    for (int number = 1; number <= kSlots && !m_own; ++number)
        m_own = takeSlot(number, Wanted::Free);
}

UnsavedWork::~UnsavedWork() = default;

std::optional<UnsavedWork::Slot> UnsavedWork::takeSlot(int number, Wanted wanted) const {
    Slot slot{QDir(m_folder).filePath(QStringLiteral("unsaved-%1").arg(number)), nullptr};
    if (QFile::exists(slot.path) != (wanted == Wanted::Used))
        return std::nullopt;
    slot.lock = std::make_unique<QLockFile>(slot.path + QStringLiteral(".lock"));
    // A lock becomes void only when its program has ended, not with age.
    slot.lock->setStaleLockTime(0);
    if (!slot.lock->tryLock(0) || QFile::exists(slot.path) != (wanted == Wanted::Used))
        return std::nullopt;
    return slot;
}

void UnsavedWork::dropLeft() {
    if (m_leftSlot)
        m_files.remove(m_leftSlot->path);
    m_left.reset();
}

void UnsavedWork::keep(const QString& file, const QString& fileHash, const std::string& content,
                       FileWriter::Done done) {
    QUrl url = QUrl::fromLocalFile(file);
    url.setFragment(fileHash);
    // Without a slot, the write fails and reports the reason.
    const QString path = m_own ? m_own->path : m_folder;
    m_files.write(
        path, [name = url.toEncoded().toStdString(), content] { return name + '\n' + content; },
        std::move(done));
}

void UnsavedWork::forget() {
    if (m_own)
        m_files.remove(m_own->path);
}

}  // namespace nmc
