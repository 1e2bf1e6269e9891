/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    pairPotential

Group
    grpPreProcessingUtilities

Description
    Energy U(h)/kT and force F(h) of two colloids, or of a colloid and a wall,
    at a gap h, from the laws of the case (colloids in
    constant/particleProperties). Tells the barrier and the minima on both
    sides of it, and the sub-step that the forces allow.

    h   gap of the surfaces   [m]
    U   energy                [J], printed over kT
    F   force, > 0 repels     [N]

    Errors: a case without colloids, an unknown material, a diameter <= 0.

Usage
    \verbatim
    pairPotential -d 1e-6                               # first material
    pairPotential -d 1e-6 -with 5e-7 -materials '(silica latex)'
    pairPotential -d 1e-6 -wall -csv pair.csv -plot pair.png
    \endverbatim

    With -wall the second material is that of the wall.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "colloidForces.H"
#include "IFstream.H"
#include "liggghtsTimeStep.H"
#include "OSspecific.H"
#include "printedTable.H"
#include "userEntry.H"

#include <functional>
#include <string>

using namespace Foam;

namespace
{

typedef std::function<dew::colloidForce(scalar)> interaction;

//- A place where the force is zero
struct extreme
{
    scalar h, U;
    bool barrier;
};


//- All of them, by bisection between gaps of equal ratio
DynamicList<extreme> extremes
(
    const interaction& f,
    const scalar first,
    const scalar last
)
{
    DynamicList<extreme> found;
    const int n = 2000;
    const scalar ratio = std::pow(last/first, 1.0/scalar(n));
    scalar h = first;
    for (int i = 0; i < n; i++, h *= ratio)
    {
        const bool repels = f(h).F > 0;
        if (repels == (f(h*ratio).F > 0))
        {
            continue;
        }
        scalar a = h, b = h*ratio;
        for (int k = 0; k < 60; k++)
        {
            const scalar middle = 0.5*(a + b);
            (repels == (f(middle).F > 0) ? a : b) = middle;
        }
        found.append(extreme{a, f(a).U, !repels});
    }
    return found;
}


void tell
(
    const interaction& f,
    const scalar first,
    const scalar last,
    const scalar kT
)
{
    const DynamicList<extreme> found(extremes(f, first, last));
    label barrier = -1;
    forAll(found, i)
    {
        if (found[i].barrier && found[i].U > 0)
        {
            barrier = i;
        }
    }

    if (f(first).F < 0)
    {
        Info<< "Primary minimum at the least gap " << first << " m: "
            << f(first).U/kT << " kT" << nl;
    }
    forAll(found, i)
    {
        const bool primary = barrier < 0 || i < barrier;
        Info<< (
                   found[i].barrier ? "Barrier"
                 : primary ? "Primary minimum" : "Secondary minimum"
               )
            << " at " << found[i].h << " m: " << found[i].U/kT << " kT" << nl;
    }
    if (barrier < 0)
    {
        Info<< "No barrier" << nl;
    }
}


//- Picture of a table of h, U/kT and F, with what is marked in it
void plot(const fileName& csv, const fileName& picture)
{
    const std::string script
    (
        "import csv, sys\n"
        "import matplotlib\n"
        "matplotlib.use(\"Agg\")\n"
        "import matplotlib.pyplot as plt\n"
        "rows = list(csv.reader(open(sys.argv[1])))[1:]\n"
        "h, U, F = zip(*[[float(v) for v in row] for row in rows])\n"
        "n = len(h)\n"
        "fig, axes = plt.subplots(2, 1, sharex=True, figsize=(6, 7))\n"
        "marked = [i for i in range(1, n - 1)\n"
        "    if (U[i] - U[i - 1])*(U[i + 1] - U[i]) < 0]\n"
        "for axis, y in zip(axes, (U, F)):\n"
        "    axis.axhline(0, color=\"0.7\", lw=0.8)\n"
        "    axis.semilogx([1e9*x for x in h], y)\n"
        "    axis.plot([1e9*h[i] for i in marked], [y[i] for i in marked],\n"
        "        \"o\")\n"
        "    axis.set_yscale(\"symlog\", linthresh=max(map(abs, y))/1e3)\n"
        "for i in marked:\n"
        "    axes[0].annotate(\"%.3g kT\" % U[i], (1e9*h[i], U[i]))\n"
        "axes[0].set_ylabel(\"U/kT\")\n"
        "axes[1].set_ylabel(\"F [N]\")\n"
        "axes[1].set_xlabel(\"gap [nm]\")\n"
        "fig.tight_layout()\n"
        "fig.savefig(sys.argv[2])\n"
    );
    const string python(getEnv("DEW_PYTHON"));
    const int failed = Foam::system
    (
        (python.empty() ? string("python3") : python)
      + " -c '" + script + "' '" + csv + "' '" + picture + "' 2> /dev/null"
    );
    if (failed)
    {
        Info<< "No picture: python3 with matplotlib is needed for it" << endl;
    }
    else
    {
        Info<< "Wrote " << picture << endl;
    }
}


//- Index of a material of the case
label materialOf(const dew::materials& mats, const word& name)
{
    dictionary dict;
    dict.add("materials", name);
    return mats.index(dict, "materials");
}


scalar diameter(const argList& args, const word& option, const scalar usual)
{
    const scalar d = args.getOrDefault<scalar>(option, usual);
    if (!(d > 0))
    {
        FatalErrorInFunction
            << "Option -" << option << ": a diameter of " << d << " m" << nl
            << "Give one above 0, e.g. -" << option << " 1e-6"
            << exit(FatalError);
    }
    return d;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Energy and force of two colloids over their gap");
    argList::noBanner();
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addOption("d", "d", "Diameter [m]");
    argList::addOption("with", "d", "Diameter of the other one [m]");
    argList::addOption("materials", "list", "Of one and the other");
    argList::addBoolOption("wall", "The other one is a wall");
    argList::addOption("rows", "n", "Rows of the table");
    argList::addOption("csv", "file", "Write comma-separated values");
    argList::addOption("plot", "file", "Write a picture (with -csv)");
    argList args(argc, argv);

    if (args.found("plot") && !args.found("csv"))
    {
        FatalErrorInFunction
            << "-plot without -csv" << nl << "Give the file to plot from"
            << exit(FatalError);
    }

    const fileName path(args.path()/"constant"/"particleProperties");
    IFstream is(path);
    if (!is.good())
    {
        FatalErrorInFunction
            << "No file " << path << nl << "Run in a case directory"
            << exit(FatalError);
    }
    const dictionary dict(is);
    const dew::materials mats
    (
        dew::userEntry::subDict(dict, "materials"),
        dew::userEntry::optionalDict(dict, "contacts"),
        false
    );

    const scalar d1 = diameter(args, "d", 0), d2 = diameter(args, "with", d1);
    const scalar R1 = 0.5*d1, R2 = 0.5*d2;
    const dew::colloidForces forces
    (
        dew::userEntry::subDict(dict, "colloids"), mats, min(R1, R2)
    );

    wordList names(2, mats.names()[0]);
    if (args.found("materials"))
    {
        names = args.getList<word>("materials");
    }
    if (names.size() != 2)
    {
        FatalErrorInFunction
            << "-materials " << names << nl << "Give two" << exit(FatalError);
    }
    const label i = materialOf(mats, names[0]), j = materialOf(mats, names[1]);
    const bool wall = args.found("wall");

    const interaction f = [&](const scalar h)
    {
        return wall ? forces.wall(i, j, R1, h) : forces.pair(i, j, R1, R2, h);
    };

    const scalar kT = forces.medium().kT();
    const scalar last = forces.cutOff()*(1 - 1e-9);
    const scalar first = max(forces.medium().minGap(), 1e-4*last);
    const label n = args.getOrDefault<label>("rows", 200);
    if (n < 2)
    {
        FatalErrorInFunction
            << "-rows " << n << nl << "Give 2 or more" << exit(FatalError);
    }

    dew::printedTable table(wordList({"h", "U/kT", "F"}));
    for (label k = 0; k < n; k++)
    {
        const scalar h = first*std::pow(last/first, scalar(k)/scalar(n - 1));
        table.append(scalarList({h, f(h).U/kT, f(h).F}));
    }
    table.print(Info);

    if (forces.medium().kappa() > 0)
    {
        Info<< "Debye length " << 1/forces.medium().kappa() << " m" << nl;
    }
    tell(f, first, last, kT);
    Info<< "At the cut-off " << forces.cutOff() << " m: " << f(last).U/kT
        << " kT" << nl;

    const dictionary& dynamics =
        dew::userEntry::optionalDict(dict, "dynamics");
    const bool overdamped =
        dynamics.getOrDefault<word>("type", "inertial") == "overdamped";
    const scalar mu =
        overdamped
      ? dew::userEntry::positive(dynamics, "viscosity", dimDynamicViscosity)
      : 0;
    const scalar stable = forces.stableTimeStep(min(R1, R2), mu);
    Info<< "Sub-step, " << (overdamped ? "overdamped" : "inertial")
        << ": stable below " << stable << " s, proposed "
        << (overdamped ? 0.2 : 0.1)*stable << " s (contacts may ask for less)"
        << nl << endl;

    if (args.found("csv"))
    {
        table.write(args["csv"]);
        if (args.found("plot"))
        {
            plot(args["csv"], args["plot"]);
        }
    }
    return 0;
}


// ************************************************************************* //
