#include "compiler/candidates/groups.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cmath>
#include <map>
#include <set>


namespace reprise {
namespace {

// Capacities are whole numbers, so that a maximum flow ends and is exact: 1/64 of a scalar addition.
using Capacity = std::int64_t;
constexpr double kUnit = 64;
constexpr std::size_t kLongShader = 10000;  // nodes
constexpr Capacity kUncuttable = Capacity{1} << 50;

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using FlowGraph = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS,
    boost::property<boost::vertex_index_t, long,
                    boost::property<boost::vertex_color_t, boost::default_color_type,
                                    boost::property<boost::vertex_distance_t, long,
                                                    boost::property<boost::vertex_predecessor_t, Traits::edge_descriptor>>>>,
    boost::property<boost::edge_capacity_t, Capacity,
                    boost::property<boost::edge_residual_capacity_t, Capacity,
                                    boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;

struct Cut {
  std::vector<std::size_t> kept;  // indices of singles, ascending
  int channels = 0;
  double tail_cost = 0;
};

// The network is built once: from cut to cut only the prices of values change.
class CutFinder {
 public:
  CutFinder(const ShaderAnalysis& analysis, const std::vector<Candidate>& singles) : analysis_(analysis), singles_(singles) { build(); }

  // Which singles may be kept from here on.
  void allow(std::vector<std::size_t> allowed) { allowed_ = std::move(allowed); }

  Cut at(double gamma) {
    setPrices(gamma);
    boost::boykov_kolmogorov_max_flow(flow_, source_, sink_);
    const auto color = boost::get(boost::vertex_color, flow_);
    // Black: reached from the source by what capacity is left.
    const auto demanded = [&](std::size_t vertex) { return color[vertex] == boost::black_color; };
    Cut cut;
    for (std::size_t node = 0; node < analysis_.graph.nodes.size(); ++node)
      if (analysis_.live[node] && demanded(out(node))) cut.tail_cost += analysis_.graph.nodes[node].cost;
    for (const std::size_t single : allowed_) {
      const auto node = static_cast<std::size_t>(singles_[single].values.front().node);
      if (!demanded(in(node)) || demanded(out(node))) continue;
      cut.kept.push_back(single);
      cut.channels += singles_[single].values.front().channels;
    }
    return cut;
  }

 private:
  static std::size_t in(std::size_t node) { return 2 * node; }
  static std::size_t out(std::size_t node) { return 2 * node + 1; }

  Traits::edge_descriptor connect(std::size_t from, std::size_t to, Capacity capacity) {
    const auto forward = boost::add_edge(from, to, flow_).first, backward = boost::add_edge(to, from, flow_).first;
    const auto capacities = boost::get(boost::edge_capacity, flow_);
    const auto reverses = boost::get(boost::edge_reverse, flow_);
    capacities[forward] = capacity;
    capacities[backward] = 0;
    reverses[forward] = backward;
    reverses[backward] = forward;
    return forward;
  }

  void setPrices(double gamma) {
    const auto capacities = boost::get(boost::edge_capacity, flow_);
    for (const auto& [node, edge] : price_of_) capacities[edge] = kUncuttable;
    for (const std::size_t single : allowed_) {
      const CandidateValue& value = singles_[single].values.front();
      const auto edge = price_of_.find(static_cast<std::size_t>(value.node));
      if (edge != price_of_.end()) capacities[edge->second] = std::llround(gamma * value.channels * kUnit);
    }
  }

  void build() {
    const ValueGraph& graph = analysis_.graph;
    source_ = 2 * graph.nodes.size();
    sink_ = source_ + 1;
    flow_ = FlowGraph(sink_ + 1);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      if (!analysis_.live[i]) continue;
      const Node& node = graph.nodes[i];
      if (node.root) connect(source_, out(i), kUncuttable);
      price_of_[i] = connect(in(i), out(i), kUncuttable);
      if (node.cost > 0) connect(out(i), sink_, std::llround(node.cost * kUnit));
      for (const int needed : node.needs) connect(out(i), in(static_cast<std::size_t>(needed)), kUncuttable);
      for (const int controller : graph.flow.controllers[static_cast<std::size_t>(node.block)])
        connect(out(i), in(static_cast<std::size_t>(graph.terminator_of_block[static_cast<std::size_t>(controller)])), kUncuttable);
    }
  }

  const ShaderAnalysis& analysis_;
  const std::vector<Candidate>& singles_;
  std::vector<std::size_t> allowed_;
  FlowGraph flow_;
  std::map<std::size_t, Traits::edge_descriptor> price_of_;  // by node
  std::size_t source_ = 0, sink_ = 0;
};

// The cuts on the hull, by the gammas at which the lines of two known neighbours meet.
std::vector<Cut> cutsOnHull(CutFinder& finder, double shader_cost, std::size_t most_cuts) {
  std::vector<Cut> cuts;
  std::vector<std::pair<Cut, Cut>> between;  // fewer channels, more channels
  const Cut none{{}, 0, shader_cost};
  Cut all = finder.at(shader_cost * 1e-5);
  std::size_t found = 1;
  cuts.push_back(all);
  between.push_back({none, std::move(all)});
  while (!between.empty() && found < most_cuts) {
    const auto [fewer, more] = between.back();
    between.pop_back();
    if (more.channels - fewer.channels < 2) continue;
    const double gamma = (fewer.tail_cost - more.tail_cost) / (more.channels - fewer.channels);
    Cut middle = finder.at(gamma);
    ++found;
    if (middle.channels <= fewer.channels || middle.channels >= more.channels) continue;
    cuts.push_back(middle);
    // Few channels first: large groups are of use where the small ones are known.
    between.push_back({middle, more});
    between.push_back({fewer, std::move(middle)});
  }
  return cuts;
}

bool changesWithNoMore(const Candidate& candidate, const std::vector<int>& inputs) {
  return std::includes(inputs.begin(), inputs.end(), candidate.inputs.begin(), candidate.inputs.end());
}

}  // namespace

std::vector<std::vector<std::size_t>> findGroups(const ShaderAnalysis& analysis, const std::vector<Candidate>& singles,
                                                 const GroupOptions& options) {
  std::vector<std::size_t> allowed;
  for (std::size_t i = 0; i < singles.size(); ++i)
    if (singles[i].kept() && !isInteger(singles[i].scalar) && 
        !analysis.differentiated[static_cast<std::size_t>(singles[i].values.front().node)])
      allowed.push_back(i);
  if (allowed.size() < 2) return {};
  std::vector<std::size_t> by_saving = allowed;
  std::stable_sort(by_saving.begin(), by_saving.end(),
                   [&](std::size_t a, std::size_t b) { return singles[a].saved_cost > singles[b].saved_cost; });
  std::vector<std::vector<std::size_t>> sets{allowed};
  std::set<std::vector<int>> seen;
  for (const std::size_t best : by_saving) {
    if (sets.size() > options.most_input_sets) break;
    if (!seen.insert(singles[best].inputs).second) continue;
    std::vector<std::size_t> set;
    for (const std::size_t single : allowed)
      if (changesWithNoMore(singles[single], singles[best].inputs)) set.push_back(single);
    if (set.size() >= 2 && set.size() < allowed.size()) sets.push_back(std::move(set));
  }
  // A cut of a very long shader takes a tenth of a second.
  const bool is_long = analysis.graph.nodes.size() > kLongShader;
  if (is_long) sets.resize(1);
  const std::size_t most_cuts = is_long ? std::min<std::size_t>(options.most_cuts, 4) : options.most_cuts;
  std::set<std::vector<std::size_t>> groups;
  CutFinder finder(analysis, singles);
  for (std::vector<std::size_t>& set : sets) {
    finder.allow(std::move(set));
    for (Cut& cut : cutsOnHull(finder, analysis.total_cost, most_cuts))
      if (cut.kept.size() >= 2 && cut.channels <= options.most_channels) groups.insert(std::move(cut.kept));
  }
  return {groups.begin(), groups.end()};
}

}  // namespace reprise
