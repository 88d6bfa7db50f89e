// Structured control flow: which loops and switches a block lies in (SPIR-V specification, 2.11 "Structured Control Flow").
//
// A construct holds the blocks that its header structurally dominates and its merge block does not. Structural dominance also counts
// the edges from headers to merge blocks and continue targets, so that a merge block that nothing reaches still ends its construct.
#pragma once

#include "compiler/ir/control_flow.h"

namespace reprise {

enum class ConstructKind { kSelection, kSwitch, kLoop };

struct Construct {
  ConstructKind kind = ConstructKind::kSelection;
  int header = kNoBlock, merge = kNoBlock;
  int continue_target = kNoBlock;  // of loops
};

class Constructs {
 public:
  Constructs(const Function& function, const ControlFlow& flow);

  const std::vector<Construct>& all() const { return all_; }
  bool contains(const Construct& construct, int block) const;
  // Blocks from the continue target to the back edge: they leave the loop by the back-edge block alone.
  bool continues(const Construct& loop, int block) const;
  // The innermost loop or switch around a block, whose merge block may be branched to before it; one that begins in the block is not
  // around it. Null if there is none.
  const Construct* breakable(int block) const;

 private:
  bool dominates(int dominator, int block) const;

  std::vector<Construct> all_;
  std::vector<int> immediate_dominator_;  // structural
};

}  // namespace reprise
