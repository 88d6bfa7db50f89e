#include "tests/fuzz/hostile_modules.h"

#include <algorithm>

#include "tests/fuzz/module_maker.h"

namespace reprise {
namespace {

using spv::Op;
using Words = std::vector<std::uint32_t>;

Operand none() { return literalOperand(0); }

// v1 = x + x, v2 = v1 + v1, ...
Words longBlock(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t value = maker.x();
  for (std::size_t i = 0; i < size; ++i) value = maker.sum(value, value);
  return maker.finish(value);
}

// Many values of nearly the same cost, none of which contains another.
Words wideBlock(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t value = maker.x();
  for (std::size_t i = 0; i < size / 2; ++i) value = maker.sum(value, maker.sum(maker.x(), maker.x()));
  return maker.finish(value);
}

Words manyInputs(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t value = maker.x();
  // Locations may be shared by unused components only; the validator counts up to a limit.
  const std::uint32_t type = maker.global(Op::OpTypeStruct, 0, std::vector<Operand>(size, idOperand(maker.real())));
  addDecoration(maker.module(), type, spv::Decoration::Block);
  for (std::uint32_t i = 0; i < size; ++i)
    maker.module().annotations.push_back(makeInstruction(
        Op::OpMemberDecorate, 0, 0, {idOperand(type), literalOperand(i), literalOperand(static_cast<std::uint32_t>(spv::Decoration::Offset)), literalOperand(4 * i)}));
  const std::uint32_t block = addVariable(maker.module(), spv::StorageClass::Uniform, type, "Many");
  addDecoration(maker.module(), block, spv::Decoration::DescriptorSet, {0});
  addDecoration(maker.module(), block, spv::Decoration::Binding, {0});
  const std::uint32_t pointer = pointerType(maker.module(), spv::StorageClass::Uniform, maker.real());
  const std::uint32_t index_type = uintType(maker.module());
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t index = maker.global(Op::OpConstant, index_type, {literalOperand(i)});
    const std::uint32_t member = maker.add(Op::OpAccessChain, pointer, {idOperand(block), idOperand(index)});
    value = maker.sum(value, maker.add(Op::OpLoad, maker.real(), {idOperand(member)}));
  }
  return maker.finish(value);
}

Words manyGlobals(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t value = maker.x();
  for (std::size_t i = 0; i < size; ++i)
    value = maker.sum(value, maker.global(Op::OpConstant, maker.real(), {literalOperand(static_cast<std::uint32_t>(i + 1))}));
  return maker.finish(value);
}

Words manyNames(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t value = maker.x();
  for (std::size_t i = 0; i < size; ++i) {
    value = maker.sum(value, value);
    addName(maker.module(), value, "v");
  }
  return maker.finish(value);
}

// Every load of an array in memory may see every store.
Words manyStores(std::size_t size) {
  ModuleMaker maker;
  const std::uint32_t length = uintConstant(maker.module(), 256);
  const std::uint32_t array = maker.global(Op::OpTypeArray, 0, {idOperand(maker.real()), idOperand(length)});
  const std::uint32_t variable = maker.localVariable(array);
  const std::uint32_t pointer = pointerType(maker.module(), spv::StorageClass::Function, maker.real());
  const std::uint32_t index = maker.add(Op::OpConvertFToU, uintType(maker.module()), {idOperand(maker.x())});
  const std::uint32_t place = maker.add(Op::OpAccessChain, pointer, {idOperand(variable), idOperand(index)});
  std::uint32_t value = maker.x();
  for (std::size_t i = 0; i < size; ++i) {
    maker.end(Op::OpStore, {idOperand(place), idOperand(value)});
    value = maker.add(Op::OpLoad, maker.real(), {idOperand(place)});
  }
  return maker.finish(value);
}

// f1 calls f2 twice, f2 calls f3 twice, ...
Words callTree(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t callee = 0, parameter = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t function = maker.beginFunction(&parameter);
    std::uint32_t value = maker.sum(parameter, parameter);
    for (int call = 0; callee != 0 && call < 2; ++call) value = maker.add(Op::OpFunctionCall, maker.real(), {idOperand(callee), idOperand(value)});
    maker.end(Op::OpReturnValue, {idOperand(value)});
    callee = function;
  }
  maker.resumeMain();
  return maker.finish(maker.add(Op::OpFunctionCall, maker.real(), {idOperand(callee), idOperand(maker.x())}));
}

// Functions that call one another in a chain: the nesting of inlining.
Words callChain(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t callee = 0, parameter = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t function = maker.beginFunction(&parameter);
    std::uint32_t value = parameter;
    if (callee != 0) value = maker.add(Op::OpFunctionCall, maker.real(), {idOperand(callee), idOperand(value)});
    maker.end(Op::OpReturnValue, {idOperand(value)});
    callee = function;
  }
  maker.resumeMain();
  return maker.finish(maker.add(Op::OpFunctionCall, maker.real(), {idOperand(callee), idOperand(maker.x())}));
}

// One function of some length that is called over and over.
Words manyCalls(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t parameter = 0;
  const std::uint32_t function = maker.beginFunction(&parameter);
  std::uint32_t value = parameter;
  for (std::size_t i = 0; i < size; ++i) value = maker.sum(value, value);
  maker.end(Op::OpReturnValue, {idOperand(value)});
  maker.resumeMain();
  value = maker.x();
  for (std::size_t i = 0; i < size; ++i) value = maker.add(Op::OpFunctionCall, maker.real(), {idOperand(function), idOperand(value)});
  return maker.finish(value);
}

// if (c) { v = v + v; } one after another.
Words manyBranches(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t value = maker.x(), before = maker.module().functions[0].blocks.back().label;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t taken = maker.id(), merge = maker.id();
    maker.end(Op::OpSelectionMerge, {idOperand(merge), none()});
    maker.end(Op::OpBranchConditional, {idOperand(maker.condition()), idOperand(taken), idOperand(merge)});
    maker.begin(taken);
    const std::uint32_t changed = maker.sum(value, value);
    maker.end(Op::OpBranch, {idOperand(merge)});
    maker.begin(merge);
    value = maker.add(Op::OpPhi, maker.real(), {idOperand(value), idOperand(before), idOperand(changed), idOperand(taken)});
    before = merge;
  }
  return maker.finish(value);
}

// if (c) { if (c) { ... v = v + v; } }
Words nestedBranches(std::size_t size) {
  ModuleMaker maker;
  const std::uint32_t variable = maker.localVariable(maker.real());
  maker.end(Op::OpStore, {idOperand(variable), idOperand(maker.x())});
  Words merges;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t taken = maker.id();
    merges.push_back(maker.id());
    maker.end(Op::OpSelectionMerge, {idOperand(merges.back()), none()});
    maker.end(Op::OpBranchConditional, {idOperand(maker.condition()), idOperand(taken), idOperand(merges.back())});
    maker.begin(taken);
  }
  for (; !merges.empty(); merges.pop_back()) {
    const std::uint32_t value = maker.add(Op::OpLoad, maker.real(), {idOperand(variable)});
    maker.end(Op::OpStore, {idOperand(variable), idOperand(maker.sum(value, value))});
    maker.end(Op::OpBranch, {idOperand(merges.back())});
    maker.begin(merges.back());
  }
  return maker.finish(maker.add(Op::OpLoad, maker.real(), {idOperand(variable)}));
}

// The same, but each merge block stands before the blocks of its construct, as if the construct had ended.
Words hiddenNesting(std::size_t size) {
  ModuleMaker maker;
  const std::uint32_t last = maker.id();
  std::uint32_t outer = last;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t taken = maker.id(), merge = i == 0 ? last : maker.id();
    maker.end(Op::OpSelectionMerge, {idOperand(merge), none()});
    maker.end(Op::OpBranchConditional, {idOperand(maker.condition()), idOperand(taken), idOperand(merge)});
    if (i > 0) {
      maker.begin(merge);
      maker.end(Op::OpBranch, {idOperand(outer)});
    }
    maker.begin(taken);
    outer = merge;
  }
  maker.end(Op::OpBranch, {idOperand(outer)});
  maker.begin(last);
  return maker.finish(maker.x());
}

struct OpenLoop {
  std::uint32_t header = 0, merge = 0, next = 0;
};

// while (c) { while (c) { ... } }, `depth` deep, `count` times; memory keeps v.
Words loops(std::size_t depth, std::size_t count) {
  ModuleMaker maker;
  const std::uint32_t variable = maker.localVariable(maker.real());
  maker.end(Op::OpStore, {idOperand(variable), idOperand(maker.x())});
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<OpenLoop> open;
    for (std::size_t level = 0; level < depth; ++level) {
      const OpenLoop loop{maker.id(), maker.id(), maker.id()};
      const std::uint32_t body = maker.id();
      maker.end(Op::OpBranch, {idOperand(loop.header)});
      maker.begin(loop.header);
      maker.end(Op::OpLoopMerge, {idOperand(loop.merge), idOperand(loop.next), none()});
      maker.end(Op::OpBranch, {idOperand(body)});
      maker.begin(body);
      open.push_back(loop);
    }
    for (; !open.empty(); open.pop_back()) {
      const std::uint32_t value = maker.add(Op::OpLoad, maker.real(), {idOperand(variable)});
      maker.end(Op::OpStore, {idOperand(variable), idOperand(maker.sum(value, value))});
      maker.end(Op::OpBranch, {idOperand(open.back().next)});
      maker.begin(open.back().next);
      const std::uint32_t again = maker.add(Op::OpFOrdLessThan, maker.boolean(), {idOperand(value), idOperand(maker.x())});
      maker.end(Op::OpBranchConditional, {idOperand(again), idOperand(open.back().header), idOperand(open.back().merge)});
      maker.begin(open.back().merge);
    }
  }
  return maker.finish(maker.add(Op::OpLoad, maker.real(), {idOperand(variable)}));
}

// Loop-carried values that take one another's places: what is known of them moves by one a pass.
Words phiChain(std::size_t size) {
  ModuleMaker maker;
  const std::uint32_t before = maker.module().functions[0].blocks.back().label;
  const std::uint32_t header = maker.id(), body = maker.id(), next = maker.id(), merge = maker.id();
  maker.end(Op::OpBranch, {idOperand(header)});
  maker.begin(header);
  const std::uint32_t first = maker.module().bound;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t follower = i + 1 < size ? first + static_cast<std::uint32_t>(i) + 1 : maker.x();
    maker.add(Op::OpPhi, maker.real(), {idOperand(maker.constant(1)), idOperand(before), idOperand(follower), idOperand(next)});
  }
  maker.end(Op::OpLoopMerge, {idOperand(merge), idOperand(next), none()});
  maker.end(Op::OpBranch, {idOperand(body)});
  maker.begin(body);
  maker.end(Op::OpBranch, {idOperand(next)});
  maker.begin(next);
  const std::uint32_t again = maker.add(Op::OpFOrdLessThan, maker.boolean(), {idOperand(first), idOperand(maker.constant(0.5f))});
  maker.end(Op::OpBranchConditional, {idOperand(again), idOperand(header), idOperand(merge)});
  maker.begin(merge);
  return maker.finish(maker.sum(first, first));
}

Words giantSwitch(std::size_t size) {
  ModuleMaker maker;
  const std::uint32_t selector = maker.add(Op::OpConvertFToU, uintType(maker.module()), {idOperand(maker.x())});
  const std::uint32_t before = maker.module().functions[0].blocks.back().label;
  const std::uint32_t merge = maker.id();
  std::vector<Operand> cases{idOperand(selector), idOperand(merge)}, sources{idOperand(maker.x()), idOperand(before)};
  Words labels;
  for (std::uint32_t i = 0; i < size; ++i) {
    labels.push_back(maker.id());
    cases.push_back(literalOperand(i));
    cases.push_back(idOperand(labels.back()));
  }
  maker.end(Op::OpSelectionMerge, {idOperand(merge), none()});
  maker.end(Op::OpSwitch, std::move(cases));
  for (const std::uint32_t label : labels) {
    maker.begin(label);
    sources.push_back(idOperand(maker.sum(maker.x(), maker.x())));
    sources.push_back(idOperand(label));
    maker.end(Op::OpBranch, {idOperand(merge)});
  }
  maker.begin(merge);
  return maker.finish(maker.add(Op::OpPhi, maker.real(), std::move(sources)));
}

// struct { struct { ... float } }, in a local variable.
Words nestedTypes(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t type = maker.real();
  for (std::size_t i = 0; i < size; ++i) type = maker.global(Op::OpTypeStruct, 0, {idOperand(type), idOperand(type)});
  const std::uint32_t variable = maker.localVariable(type);
  std::vector<Operand> path{idOperand(variable)};
  for (std::size_t i = 0; i < size; ++i) path.push_back(idOperand(uintConstant(maker.module(), 0)));
  const std::uint32_t pointer = pointerType(maker.module(), spv::StorageClass::Function, maker.real());
  const std::uint32_t place = maker.add(Op::OpAccessChain, pointer, std::move(path));
  maker.end(Op::OpStore, {idOperand(place), idOperand(maker.x())});
  const std::uint32_t value = maker.add(Op::OpLoad, maker.real(), {idOperand(place)});
  return maker.finish(maker.sum(value, maker.x()));
}

// Locals of large structs: what takes them apart makes a variable of each member.
Words largeLocals(std::size_t size) {
  ModuleMaker maker;
  const std::uint32_t type = maker.global(Op::OpTypeStruct, 0, std::vector<Operand>(99, idOperand(maker.real())));
  const std::uint32_t outer = maker.global(Op::OpTypeStruct, 0, std::vector<Operand>(99, idOperand(type)));
  Words variables;
  for (std::size_t i = 0; i < size; ++i) variables.push_back(maker.localVariable(outer));
  for (std::size_t i = 1; i < size; ++i)
    maker.end(Op::OpStore, {idOperand(variables[i]), idOperand(maker.add(Op::OpLoad, outer, {idOperand(variables[i - 1])}))});
  const std::uint32_t pointer = pointerType(maker.module(), spv::StorageClass::Function, maker.real());
  const Operand zero = idOperand(uintConstant(maker.module(), 0));
  const std::uint32_t place = maker.add(Op::OpAccessChain, pointer, {idOperand(variables.back()), zero, zero});
  return maker.finish(maker.sum(maker.add(Op::OpLoad, maker.real(), {idOperand(place)}), maker.x()));
}

// if (c) return; over and over, in a function: what merges returns guards all that follows each.
Words manyReturns(std::size_t size) {
  ModuleMaker maker;
  std::uint32_t parameter = 0;
  const std::uint32_t function = maker.beginFunction(&parameter);
  std::uint32_t value = parameter;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t condition = maker.add(Op::OpFOrdLessThan, maker.boolean(), {idOperand(value), idOperand(maker.constant(0.5f))});
    const std::uint32_t taken = maker.id(), merge = maker.id();
    maker.end(Op::OpSelectionMerge, {idOperand(merge), none()});
    maker.end(Op::OpBranchConditional, {idOperand(condition), idOperand(taken), idOperand(merge)});
    maker.begin(taken);
    maker.end(Op::OpReturnValue, {idOperand(value)});
    maker.begin(merge);
    value = maker.sum(value, value);
  }
  maker.end(Op::OpReturnValue, {idOperand(value)});
  maker.resumeMain();
  return maker.finish(maker.add(Op::OpFunctionCall, maker.real(), {idOperand(function), idOperand(maker.x())}));
}

Words hugeBound(std::size_t bound) {
  Words words = longBlock(4);
  words[3] = static_cast<std::uint32_t>(bound);
  return words;
}

}  // namespace

const std::vector<HostileModule>& hostileModules() {
  const auto nested = [](std::size_t depth) { return [depth](std::size_t size) { return loops(depth, size); }; };
  static const std::vector<HostileModule> modules = {
      // As large as the file may be.
      {"LongBlock", longBlock, 52000},
      {"WideBlock", wideBlock, 52000},
      {"ManyInputs", manyInputs, 9000},
      {"ManyGlobals", manyGlobals, 28000},
      {"ManyNames", manyNames, 32000},
      {"ManyStores", manyStores, 36000},
      {"CallTree", callTree, 5000},
      {"CallChain", callChain, 12000},
      {"ManyCalls", manyCalls, 20000},
      {"ManyBranches", manyBranches, 10000},
      {"NestedBranches", nestedBranches, 8000},
      {"HiddenNesting", hiddenNesting, 1000},
      {"ManyLoops", nested(1), 6500},
      {"ManyNestedLoops", nested(500), 13},
      {"PhiChain", phiChain, 37000},
      {"GiantSwitch", giantSwitch, 16000},
      {"NestedTypes", nestedTypes, 250},
      {"LargeLocals", largeLocals, 20000},
      {"ManyReturns", manyReturns, 11000},
      {"HugeBound", hugeBound, 0x3fffff},
      // As large as our limits let them be.
      {"LongBlockAtLimit", longBlock, 39000},
      {"WideBlockAtLimit", wideBlock, 26000},
      {"ManyInputsAtLimit", manyInputs, 1000},
      {"ManyStoresAtLimit", manyStores, 19000},
      {"CallTreeAtLimit", callTree, 12},
      {"DeepCallTree", callTree, 40},
      {"CallChainAtLimit", callChain, 250},
      {"ManyCallsAtLimit", manyCalls, 190},
      {"ManyBranchesAtLimit", manyBranches, 2000},
      {"NestedBranchesAtLimit", nestedBranches, 62},
      {"ManyLoopsAtLimit", nested(1), 500},
      {"ManyNestedLoopsAtLimit", nested(62), 8},
      {"GiantSwitchAtLimit", giantSwitch, 8000},
      {"NestedTypesAtLimit", nestedTypes, 12},
      {"LargeLocalsAtLimit", largeLocals, 100},
      {"ManyReturnsAtLimit", manyReturns, 1000},
      {"HugeBoundAtLimit", hugeBound, (1u << 20) - 1}};
  return modules;
}

Words longShader(std::size_t instructions) {
  ModuleMaker maker;
  std::uint32_t value = maker.x(), before = maker.module().functions[0].blocks.back().label;
  for (std::size_t made = 0; made < instructions; made += 30) {
    const std::uint32_t y = maker.add(Op::OpLoad, maker.real(), {idOperand(maker.module().entry_points[0].word(4))});
    std::uint32_t detail = maker.sum(value, y);
    for (int i = 0; i < 20; ++i) detail = i % 2 == 0 ? maker.sum(detail, maker.constant(static_cast<float>(i))) : maker.add(Op::OpFMul, maker.real(), {idOperand(detail), idOperand(value)});
    addName(maker.module(), detail, "detail");
    const std::uint32_t taken = maker.id(), merge = maker.id();
    maker.end(Op::OpSelectionMerge, {idOperand(merge), none()});
    maker.end(Op::OpBranchConditional, {idOperand(maker.condition()), idOperand(taken), idOperand(merge)});
    maker.begin(taken);
    const std::uint32_t changed = maker.sum(detail, value);
    maker.end(Op::OpBranch, {idOperand(merge)});
    maker.begin(merge);
    value = maker.add(Op::OpPhi, maker.real(), {idOperand(detail), idOperand(before), idOperand(changed), idOperand(taken)});
    before = merge;
  }
  return maker.finish(value);
}

}  // namespace reprise
