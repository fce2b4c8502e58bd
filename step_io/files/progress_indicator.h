#pragma once

#include "suture/base/progress.h"

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>

#include <string>

namespace suture::io {

/// Hands OCCT's progress on to ours, and our wish to stop on to OCCT. Maps OCCT's 0..1 to the part
/// [from, to] of the stage.
class ProgressIndicator : public Message_ProgressIndicator {
  public:
    ProgressIndicator(const Progress& progress, std::string stage, double from, double to)
        : progress_(progress), stage_(std::move(stage)), from_(from), to_(to) {}

  private:
    Standard_Boolean UserBreak() override { return progress_.cancelled(); }
    void Show(const Message_ProgressScope& /*scope*/, Standard_Boolean /*force*/) override {
        progress_(from_ + (to_ - from_) * GetPosition(), stage_);
    }

    const Progress& progress_;
    std::string stage_;
    double from_, to_;
};

}  // namespace suture::io
