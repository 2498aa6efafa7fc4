// Leaves out of Emscripten's JavaScript what nobody asks for: it brings its file system, its window and what they stand on
// whole. What is named nowhere else goes, again and again, for it may have been the last to name something.

// The objects of which single members may go: nobody reaches for one by a name that is made up as it runs.
const objects = new Set(['FS', 'MEMFS', 'TTY', 'PATH', 'PATH_FS', 'SYSCALLS', 'GLFW', 'GL', 'Browser', 'MainLoop']);
const is_function = (node) => ['FunctionExpression', 'ArrowFunctionExpression'].includes(node?.type);
const is_of = (node, object) => node?.type === 'MemberExpression' && node.object.name === object;

// `asked`: the names by which other scripts ask for something.
export function pruned(script, acorn, asked) {
  const options = { ecmaVersion: 2022 };
  let text = script;
  for (;;) {
    const times = new Map;
    for (const { type, value } of acorn.tokenizer(text, options))
      if (type.label === 'name' || type.label === 'string') times.set(value, (times.get(value) ?? 0) + 1);
    const is_unused = (name) => times.get(name) === 1 && !asked.has(name);

    const cuts = [];
    // Of what stands between commas.
    const cut_of = (items, goes) => {
      const last = items.findLastIndex((item) => !goes(item));
      items.slice(0, last).forEach((item, i) => goes(item) && cuts.push([item.start, items[i + 1].start]));
      if (last + 1 < items.length) cuts.push([last < 0 ? items[0].start : items[last].end, items.at(-1).end]);
    };
    const visit = (node) => {
      if (Array.isArray(node)) return node.forEach(visit);
      if (!node || typeof node !== 'object') return;
      const { start, end, type, id, init, declarations, expression, test, consequent, alternate } = node;
      if (type === 'VariableDeclarator' && objects.has(id.name) && init?.type === 'ObjectExpression')
        cut_of(init.properties, ({ kind, computed, key }) => kind === 'init' && !computed && is_unused(key.name ?? key.value));
      if (type === 'VariableDeclaration') {
        const goes = (one) => is_unused(one.id.name) && (is_function(one.init) || is_of(one.init, 'FS'));
        if (declarations.every(goes)) cuts.push([start, end]);
        else cut_of(declarations, goes);
      }
      if (type === 'FunctionDeclaration' && is_unused(id.name)) cuts.push([start, end]);
      if (type === 'ExpressionStatement' && expression.type === 'AssignmentExpression') {
        const { left } = expression; // what it offers to others, and what it adds to its file system
        if ((is_of(left, 'Module') && /^FS_/.test(left.property.value)) || (is_of(left, 'FS') && is_unused(left.property.name)))
          cuts.push([start, end]);
      }
      if (type === 'IfStatement' && test.name === 'ENVIRONMENT_IS_NODE') { // where tests run what the compiler made
        if (alternate) cuts.push([start, alternate.start]);
        else if (consequent.body?.length) cuts.push([consequent.start + 1, consequent.end - 1]);
      }
      Object.values(node).forEach(visit);
    };
    visit(acorn.parse(text, options));
    if (cuts.length === 0) return text;
    let from = text.length;
    for (const [start, end] of cuts.sort(([a, to_a], [b, to_b]) => b - a || to_b - to_a)) {
      if (end > from) continue; // within another
      text = text.slice(0, start) + text.slice(end);
      from = start;
    }
  }
}
