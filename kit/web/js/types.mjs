// SPDX-License-Identifier: MIT
// Which TypeScript types does the module have?

const bases = { Body: 'BodyView', BodyShape: 'BodyShapeView', Joint: 'JointView', Field: 'FieldView' };
const ids = ['BodyId', 'ShapeId', 'JointId', 'FieldId'];

/** The type of a value of a kind; out: one that the module gives, which is complete. */
function typeOf(kind, out) {
  const plain = { number: 'number', bool: 'boolean', bits: out ? 'bigint' : 'number | bigint', tag: 'number | bigint',
                  vec: out ? 'Vector' : 'Vec2', text: 'string', rule: 'ContactRule | null', world: 'World', nothing: 'void' };
  if (typeof kind === 'string') return plain[kind];
  if (kind.integer) return 'number';
  if (kind.oneOf) return kind.oneOf;
  if (kind.maybe) return `${typeOf(kind.maybe, out)} | null`;
  if (kind.listOf) return `${out ? '' : 'readonly '}${wrapped(typeOf(kind.listOf, out))}[]`;
  if (kind.mapTo) return `Record<string, ${typeOf(kind.mapTo, out)}>`;
  if (kind.either) {
    const alias = aliases[Object.keys(kind.either)[0]];
    return alias ? (out ? `Full<${alias}>` : alias) : alternatives(kind);
  }
  if (kind.state) return kind.state;
  if (kind.view) return kind.view;
  if (kind.struct === 'PathPieces') return 'MotionPath';
  if (ids.includes(kind.struct)) return kind.struct;
  return out ? `Full<${kind.struct}>` : kind.struct;
}
/** What the kit calls one of several alternatives, by the first of them. */
const aliases = { circle: 'Shape', revolute: 'JointDef', uniformGravity: 'FieldLaw' };
const alternatives = kind =>
  `OneOf<{ ${Object.entries(kind.either).map(([tag, one]) => `${tag}: ${typeOf(one, false)}`).join('; ')} }>`;

const wrapped = type => (type.includes('|') ? `(${type})` : type);

const literal = value => JSON.stringify(value)?.replace(/"(-?Infinity|NaN|\d{10,})"/g, '$1') ?? '';

function comment(text, indent) {
  if (!text) return '';
  const words = text.replace(/\*\//g, '* /').split(' '), lines = [''];
  for (const word of words) {
    if ((lines.at(-1) + word).length > 100) lines.push('');
    lines[lines.length - 1] += (lines.at(-1) ? ' ' : '') + word;
  }
  if (lines.length === 1) return `${indent}/** ${lines[0]} */\n`;
  return `${indent}/**\n${lines.map(line => `${indent} * ${line}\n`).join('')}${indent} */\n`;
}

function memberComment(struct, { name, kind, value, unit, meaning }, docs) {
  const said = meaning ? meaning + (unit && unit !== '-' ? ` [${unit}]` : '') : docs.get(`${struct}.${name}`) ?? '';
  const simple = value !== null && !(typeof value === 'object' && !Array.isArray(value)) && literal(value).length < 40;
  return said + (simple ? `${said ? '; ' : ''}default ${literal(value)}` : '');
}

function structType(name, members, docs) {
  const lines = members.map(member =>
    comment(memberComment(name, member, docs), '  ') +
    `  ${member.name}${member.value === null && (member.kind.state || member.kind.struct) && !ids.includes(member.kind.struct) ? '' : '?'}: ${typeOf(member.kind, false)};\n`);
  return `${comment(docs.get(name), '')}export interface ${name} {\n${lines.join('')}}\n`;
}

function parameterType(text, kind) {
  const name = text.split(' = ')[0].replace('?', ''), optional = text.includes('?') || text.includes(' = ');
  const inner = optional && kind.maybe ? kind.maybe : kind;
  const type = ids.includes(inner.struct) && !optional ? inner.struct : typeOf(inner, false);
  return `${name}${optional ? '?' : ''}: ${type}`;
}

function signature({ owner, name, parameters, kinds, result }) {
  const offset = owner && name !== 'new' ? 1 : 0;
  const list = parameters ? parameters.split(', ').map((text, i) => parameterType(text, kinds[i + offset])) : [];
  return `(${list.join(', ')})` + (name === 'new' ? '' : `: ${typeOf(result, true)}`);
}

/** What is said of one of several functions of one name is not said of the others. */
function docOf({ owner, name, parameters }, docs, calls) {
  const names = parameters.split(', ').map(text => /^\w*/.exec(text)[0]);
  const all = `(${names.join(',')})`, first = `(${names[0]}`, scopes = owner ? [`${owner}.`, `${bases[owner]}.`] : [''];
  const alone = calls.filter(c => c.owner === owner && c.name === name).length === 1;
  for (const key of [name + all, name + first, ...(alone ? [name] : [])])
    for (const scope of scopes) if (docs.has(scope + key)) return docs.get(scope + key);
  return '';
}

/** The kinds with several alternatives, by the names that the kit has for them. */
function aliasesOf(schema) {
  const found = {};
  const look = kind => {
    if (typeof kind !== 'object' || kind === null) return;
    const alias = kind.either && aliases[Object.keys(kind.either)[0]];
    if (alias) found[alias] = kind;
    for (const part of Object.values(kind)) look(part);
  };
  for (const { kinds } of schema.calls) kinds.forEach(look);
  for (const members of Object.values(schema.types)) members.forEach(member => look(member.kind));
  return found;
}

/** The names of members with 64 bits that are no label, which the module gives as a BigInt. */
function bitsMembers(schema) {
  const members = Object.values(schema.types).flat().filter(member => member.kind === 'bits');
  return [...new Set(members.map(member => `'${member.name}'`))].join(' | ');
}

function classType(owner, calls, docs, extra) {
  const lines = calls.filter(c => c.owner === owner).map(call => {
    const name = call.name === 'new' ? 'constructor' : call.name;
    return `${comment(docOf(call, docs, calls), '  ')}  ${name}${name === 'copy' ? '(): World' : signature(call)};\n`;
  });
  return `${comment(docs.get(owner), '')}export interface ${owner} {\n${extra}${lines.filter(l => !l.includes('  constructor(')).join('')}}\n`;
}

function constructorsOf(calls) {
  return calls.filter(c => c.name === 'new')
    .map(call => `  ${call.owner}: { new ${signature(call)}: ${call.owner}; prototype: ${call.owner} };\n`).join('');
}

const shown = `  /** What JSON.stringify shows of it. */
  toJSON(): object;
`;
const worldExtra = `  /** x, y and angle of each body, at 3 times the index of its id; NaN where no body is. The same array, filled anew, at each call [m, rad]. */
  poses(): Float64Array;
  /** The poses before the last step, in the same way; each step keeps them from the first call on. A body that came after the step is where it is now. */
  posesBefore(): Float64Array;
  /** Velocity of the centre of mass and angular velocity, in the same way [m/s, rad/s]. */
  velocities(): Float64Array;
  /** A row of contactColumns for each point at which two shapes touch. */
  contacts(): Float64Array;
  /** A row of eventColumns for each event of the last step. */
  events(): Float64Array;
${shown}`;

export function typesOf(schema, docs, heading) {
  const calls = schema.calls, plain = calls.filter(c => !c.owner && !['pathLength', 'pathPlaceAt'].includes(c.name));
  const structs = Object.entries(schema.types).filter(([name]) => !ids.includes(name) && name !== 'PathPieces');
  const view = id => `  readonly world: World;\n  id(): ${id};\n${shown}`;
  const id = name => `export interface ${name} { readonly kind: '${name}'; ` +
    'readonly index: number; readonly generation: number; readonly world: number';
  return `${heading}
/** x and y. */
export type Vec2 = readonly [number, number] | { readonly x: number; readonly y: number };
/** A vector that the module gives: the array [x, y], which has x and y, too. It is a copy: changing it would change nothing. */
export type Vector = readonly [x: number, y: number] & { readonly x: number; readonly y: number };
/** A value of which no member is missing, as the module gives it. */
export type Full<T> = T extends Vec2 ? Vector : T extends readonly (infer U)[] ? Full<U>[]
  : T extends BodyId | ShapeId | JointId | FieldId | Random | MotionPath | Function ? T : T extends object ? FullObject<T> : T;
type FullObject<T> = { [K in keyof T as Given<T, K> extends never ? never : K]-?: K extends BitsMember ? bigint : Full<Given<T, K>> }
  & { [K in keyof T as Given<T, K> extends never ? K : never]?: never };
type BitsMember = ${bitsMembers(schema)};
type Given<T, K extends keyof T> = Exclude<T[K], undefined>;
/** Exactly one of the members. */
export type OneOf<T> = { [K in keyof T]: { [P in K]: T[P] } & { [P in Exclude<keyof T, K>]?: never } }[keyof T];
/** ${docs.get('ContactRule') ?? 'May the two shapes touch?'} */
export type ContactRule = (candidate: Full<ContactCandidate>) => boolean;

${id('BodyId')}; /** The id of one of its shapes, which are counted from 0. */ shape(number: number): ShapeId }
${id('JointId')} }
${id('FieldId')} }
export interface ShapeId { readonly kind: 'ShapeId'; readonly body: BodyId; readonly number: number }

${Object.entries(schema.enumerations).map(([name, words]) => `${comment(docs.get(name), '')}export type ${name} = ${words.map(w => `'${w}'`).join(' | ')};\n`).join('')}
${Object.entries(aliasesOf(schema)).map(([name, kind]) => `${comment(docs.get(name), '')}export type ${name} = ${alternatives(kind)};\n`).join('')}
${structs.map(([name, members]) => structType(name, members, docs)).join('')}
${classType('World', calls, docs, worldExtra)}
${classType('Body', calls, docs, view('BodyId'))}
${classType('BodyShape', calls, docs, view('ShapeId'))}
${classType('Joint', calls, docs, view('JointId'))}
${classType('Field', calls, docs, view('FieldId'))}
${['GridMover', 'PlatformMover', 'PathMover'].map(name => classType(name, calls, docs, `  readonly world: World;\n${shown}`)).join('')}
${['FixedClock', 'Random'].map(name => classType(name, calls, docs, `  copy(): ${name};\n${name === 'FixedClock' ? shown : ''}`)).join('')}
${comment(docs.get('MotionPath'), '')}export interface MotionPath {
  lineTo(end: Vec2): this;
  arcAround(center: Vec2, angle: number): this;
  curveTo(first: Vec2, second: Vec2, end: Vec2): this;
  close(): this;
  length(): number;
  at(along: number): Full<PathPlace>;
}

export interface Plumb {
${constructorsOf(calls)}  readonly Body: { prototype: Body };
  readonly BodyShape: { prototype: BodyShape };
  readonly Joint: { prototype: Joint };
  readonly Field: { prototype: Field };
  MotionPath: { new (start: Vec2): MotionPath };
  splineThrough(points: readonly Vec2[], closed?: boolean): MotionPath;
${plain.map(call => `${comment(docOf(call, docs, calls), '  ')}  ${call.name}${signature(call)};\n`).join('')}  readonly unlimited: number;
  readonly contactColumns: readonly string[];
  readonly eventColumns: readonly string[];
  readonly eventKinds: readonly string[];
  readonly memory: WebAssembly.Memory;
}

/** Where the module is: its bytes, its URL, or a Response; without it, plumb.wasm beside this file. */
export type Source = string | URL | ArrayBuffer | ArrayBufferView | Response | WebAssembly.Module | Promise<Response>;
export function load(source?: Source): Promise<Plumb>;
export default load;
export const contactColumns: readonly string[];
export const eventColumns: readonly string[];
export const eventKinds: readonly string[];
`;
}
