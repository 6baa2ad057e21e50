// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "link/files/filewriter.h"

class QLockFile;

namespace nmc {

/// Work that is not saved yet, kept in a file of its own, so that neither a crash nor a careless close loses
/// it. Each running program has its own; what a program that is gone has left is found by the next one. Only
/// the start and the end wait for the disk. GUI thread.
class UnsavedWork {
public:
    struct Left {
        QString file;  ///< what it was to be saved as; may be empty
        std::string content;
    };

    /// `folder` need not be there; it is made.
    explicit UnsavedWork(const QString& folder, FileWriter::Disk disk = writeFile);
    ~UnsavedWork();
    UnsavedWork(const UnsavedWork&) = delete;
    UnsavedWork& operator=(const UnsavedWork&) = delete;

    /// What another session has left; it stays there until it is dropped.
    [[nodiscard]] const std::optional<Left>& left() const { return m_left; }
    void dropLeft();

    /// Replaces what this session kept before. `told`: as FileWriter's.
    void keep(const QString& file, const std::string& content, FileWriter::Told told);
    /// Everything is saved, or not wanted any more.
    void forget();

private:
    /// A file that only one program at a time may use.
    struct Slot {
        QString path;
        std::unique_ptr<QLockFile> lock;
    };
    enum class Wanted : std::uint8_t { Used, Free };
    [[nodiscard]] std::optional<Slot> takeSlot(Wanted wanted) const;

    QString m_folder;
    std::optional<Slot> m_leftSlot;
    std::optional<Left> m_left;
    std::optional<Slot> m_own;
    FileWriter m_files;  ///< ends before the locks do
};

}  // namespace nmc
