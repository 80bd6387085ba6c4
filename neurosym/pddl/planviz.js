// Draws the states of a plan from above, for the extension "PDDL" of Visual Studio Code. Written by neurosym;
// do not edit: compile-domain and new-problem write it again, with the scenes of all problems of the folder.
// Below stands the robot, x leads away from it, and y to its left.
module.exports = (function (data) {
    "use strict";
    const MARGIN = 0.03, NOTES = new Set(["look-on", "reach-place", "leave-start", "reach-goal"]);
    const LATER = /^(finish-.*|move-[xyz])$/;
    const COLOURS = ["#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#997700", "#555555"];

    /** Returns text as HTML. */
    function escaped(text) {
        return String(text).replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");
    }

    /** Returns the scene of a plan's problem, or null. */
    function sceneOf(plan) {
        const name = plan && plan.problem && plan.problem.name;
        return name && Object.hasOwn(data.problems, name) ? data.problems[name] : null;
    }

    /** Returns where every object stands: as the scene says, then as facts do, in any order. */
    function stateOf(scene, facts) {
        const state = {};
        for (const name of Object.keys(scene.objects)) {
            state[name] = { at: scene.objects[name].at.slice(), z: 0 };
        }
        for (const led of [false, true]) { // cells say more than the place where something started
            for (const fact of facts) {
                const words = fact.variableName.toLowerCase().split(" ");
                if (fact.value === false || words.length !== 3 || !state[words[1]]) { continue; }
                if (!led && words[0] === "stands") { moveToPlace(state, scene, words[1], words[2]); }
                if (led && /^at-[xyz]$/.test(words[0])) { moveToCell(state, scene, words[1], words[2]); }
            }
        }
        return state;
    }

    /** Returns where a place lies, or null: names of spots say so themselves, in tenths of a millimetre. */
    function placeNamed(scene, place) {
        const spot = /^spot-(m?\d+)-(m?\d+)$/.exec(place);
        if (Object.hasOwn(scene.places, place)) { return scene.places[place].slice(); }
        return spot && spot.slice(1).map(word => Number(word.replace("m", "-")) / 10000);
    }

    function moveToPlace(state, scene, name, place) {
        const at = placeNamed(scene, place);
        if (at) { state[name] = { at: at, z: 0 }; }
        return at !== null;
    }

    /** Moves an object along an axis, as far from where it started as its cell is from the one it started in. */
    function moveToCell(state, scene, name, cell) {
        const axis = "xyz".indexOf(cell[0]), index = Number(cell.slice(1));
        if (axis === 2) {
            state[name].z = index;
        } else {
            const object = scene.objects[name];
            state[name].at[axis] = object.at[axis] + (index - object.cell[axis]) * data.cell;
        }
    }

    /** Does a step of a plan; returns what to write below the picture, or "" if it belongs to the step before. */
    function act(state, scene, words) {
        const name = words.slice(1).find(word => Object.hasOwn(scene.objects, word));
        if (name === undefined || NOTES.has(words[0])) { return ""; }
        const after = words.slice(words.indexOf(name) + 1);
        for (const place of [after[1], after[0]]) { // from one place to another, or only where to
            if (place !== undefined && moveToPlace(state, scene, name, place)) {
                return [words[0], name, place].join(" ");
            }
        }
        for (const word of words) {
            if (/^[xyz]\d+$/.test(word)) { moveToCell(state, scene, name, word); }
        }
        return LATER.test(words[0]) ? "" : words[0] + " " + name;
    }

    /** Returns the states of a plan, with what led to each. */
    function framesOf(plan, scene) {
        const inits = plan.problem.getInits ? plan.problem.getInits() : plan.problem.inits || [];
        const state = stateOf(scene, inits);
        const frames = [{ said: "start", state: copied(state) }];
        for (const step of plan.steps) {
            const said = act(state, scene, step.fullActionName.toLowerCase().split(" "));
            const frame = { said: said || frames[frames.length - 1].said, state: copied(state) };
            if (said) { frames.push(frame); } else { frames[frames.length - 1] = frame; }
        }
        return frames;
    }

    function copied(state) {
        return JSON.parse(JSON.stringify(state));
    }

    /** Returns the picture of a state, some pixels wide. */
    function drawn(scene, state, width) {
        const [left, right] = [data.table.y[1] + MARGIN, data.table.y[0] - MARGIN];
        const [far, near] = [data.table.x[1] + MARGIN, data.table.x[0] - MARGIN];
        const scale = width / (left - right), height = (far - near) * scale;
        const across = y => (left - y) * scale, down = x => (far - x) * scale;
        const number = value => (Math.round(10 * value) / 10).toString();
        const box = (at, size, looks) => `<rect x="${number(across(at[1]) - size[1] * scale / 2)}" ` +
            `y="${number(down(at[0]) - size[0] * scale / 2)}" width="${number(size[1] * scale)}" ` +
            `height="${number(size[0] * scale)}" ${looks}/>`;
        const words = (at, text, looks) => `<text x="${number(across(at[1]))}" y="${number(down(at[0]))}" ` +
            `text-anchor="middle" dominant-baseline="central" font-size="${number(width / 30)}" ${looks}>` +
            `${escaped(text)}</text>`;
        const table = [data.table.x[1] - data.table.x[0], data.table.y[1] - data.table.y[0]];
        const middle = [data.table.x[0] + table[0] / 2, data.table.y[0] + table[1] / 2];
        const parts = [`<rect width="${number(width)}" height="${number(height)}" fill="#ffffff"/>`,
            box(middle, table, `class="table" fill="#f4efe6" stroke="#998877"`)];
        for (const place of Object.keys(scene.places).filter(name => !name.startsWith("start-"))) {
            const at = scene.places[place];
            parts.push(`<circle class="place" cx="${number(across(at[1]))}" cy="${number(down(at[0]))}" r="3" ` +
                `fill="#998877"><title>${escaped(place)}</title></circle>`);
        }
        Object.keys(scene.objects).forEach((name, row) => {
            const colour = COLOURS[row % COLOURS.length], object = scene.objects[name];
            if (Object.hasOwn(scene.goals, name)) {
                parts.push(box(scene.goals[name], object.size,
                    `class="goal" fill="none" stroke="${colour}" stroke-dasharray="4 3"`));
            }
        });
        Object.keys(scene.objects).forEach((name, row) => {
            const colour = COLOURS[row % COLOURS.length], object = scene.objects[name], { at, z } = state[name];
            const turn = object.turn ? ` transform="rotate(${number(-object.turn)} ${number(across(at[1]))} ` +
                `${number(down(at[0]))})"` : "";
            parts.push(box(at, object.size, `class="object" fill="${colour}" fill-opacity="${z > 0 ? 0.3 : 0.75}" ` +
                `stroke="${colour}"${turn}`));
            parts.push(words(at, name + (z > 0 ? " (held)" : ""), `fill="#000000"`));
        });
        return `<svg xmlns="http://www.w3.org/2000/svg" width="${number(width)}" height="${number(height)}" ` +
            `viewBox="0 0 ${number(width)} ${number(height)}">${parts.join("")}</svg>`;
    }

    function unknown(plan) {
        const name = plan && plan.problem ? `the problem ${plan.problem.name}` : "this plan, which has no problem";
        return `<p>neurosym knows no scene of ${escaped(name)}; run neurosym compile-domain on its folder.</p>`;
    }

    /** Returns HTML with a picture of the start and one of the state after each step. */
    function visualizePlanHtml(plan, displayWidth) {
        const scene = sceneOf(plan);
        if (!scene) { return unknown(plan); }
        const frames = framesOf(plan, scene);
        const width = frames.length > 1 ? Math.max(120, displayWidth / 2 - 8) : displayWidth;
        const figures = frames.map((frame, step) => `<figure style="display: inline-block; margin: 2px; ` +
            `width: ${Math.round(width)}px;">${drawn(scene, frame.state, width)}<figcaption>` +
            `${step ? step + ". " : ""}${escaped(frame.said)}</figcaption></figure>`);
        return `<div>${figures.join("")}</div>`;
    }

    /** Returns HTML with a picture of one state. */
    function visualizeStateHtml(plan, finalState, displayWidth) {
        const scene = sceneOf(plan);
        return scene ? drawn(scene, stateOf(scene, finalState), displayWidth) : unknown(plan);
    }

    return { visualizePlanHtml: visualizePlanHtml, visualizeStateHtml: visualizeStateHtml };
})(/* scenes */ {});
