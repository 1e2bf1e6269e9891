/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    thermoTable

Group
    grpPreProcessingUtilities

Description
    Prints properties of liquids, gases and their equilibrium over temperature
    or composition: of a species by name, or of the mixtures of a case, which
    are in constant/liquidProperties and constant/gasProperties.

    Units: SI; fractions are mole fractions.

    Errors: an unknown species, phase or property, with a list of those known;
    fractions that do not fit the liquids. Temperatures outside the range of a
    liquid's properties are told.

Usage
    \verbatim
    thermoTable -list                                   # what is known
    thermoTable -liquid ethanol -T '(280 360 9)'        # from, to, rows
    thermoTable -liquid ethanol -property pSat -csv pSat.csv -plot pSat.png
    thermoTable -gas N2 -T '(300 1000 8)'

    # in the case directory
    thermoTable -phase liquid -T 298.15 -across 11      # over x of the first
    thermoTable -phase gas -x '(0.02 0.01)'             # of the vapours
    thermoTable -VLE -p 101325 -across 21               # T and y over x
    \endverbatim

    -T is one temperature or (from to rows), 298.15 if not given; -p is 101325
    if not given.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "gasFits.H"
#include "IFstream.H"
#include "IStringStream.H"
#include "liquidProperties.H"
#include "mixedGas.H"
#include "printedTable.H"
#include "speciesData.H"
#include "tableColumns.H"
#include "UNIFACGroups.H"

#include <string>

using namespace Foam;
using namespace Foam::dew::tableColumns;

namespace
{

//- Names on one line
std::string line(const UList<word>& names)
{
    std::string all;
    for (const word& name : names)
    {
        all += (all.empty() ? "" : " ") + name;
    }
    return all;
}


dictionary caseDictionary(const argList& args, const word& name)
{
    const fileName path(args.path()/"constant"/name);
    IFstream is(path);
    if (!is.good())
    {
        FatalErrorInFunction
            << "No file " << path << nl << "Run in a case directory, or give"
            << " -liquid or -gas" << exit(FatalError);
    }
    dictionary dict(is);
    dict.remove("FoamFile");
    return dict;
}


scalarList numbers(const argList& args, const word& option)
{
    IStringStream is(args[option]);
    const token first(is);
    is.rewind();
    if (first.isNumber())
    {
        return scalarList(1, readScalar(args[option]));
    }
    return scalarList(is);
}


scalarList temperatures(const argList& args)
{
    if (!args.found("T"))
    {
        return scalarList(1, 298.15);
    }
    const scalarList given(numbers(args, "T"));
    if (given.size() == 1)
    {
        return given;
    }
    if
    (
        given.size() != 3 || !(given[0] > 0 && given[1] > given[0])
     || given[2] < 2 || given[2] > 1e6
    )
    {
        FatalErrorInFunction
            << "Temperatures -T " << args["T"] << nl
            << "Give one, or (from to rows) with 2 rows or more"
            << exit(FatalError);
    }
    const label n = given[2];
    scalarList T(n);
    forAll(T, i)
    {
        T[i] = given[0] + i*(given[1] - given[0])/(T.size() - 1);
    }
    return T;
}


//- The properties asked for
properties chosen(const argList& args, const properties& all)
{
    if (!args.found("property"))
    {
        return all;
    }
    const word name(args["property"]);
    properties found;
    DynamicList<word> known;
    for (const property& q : all)
    {
        known.append(q.name);
        if (q.name == name)
        {
            found.append(q);
        }
    }
    if (found.empty())
    {
        FatalErrorInFunction
            << "Unknown property " << name << nl << "Known here: "
            << line(known).c_str() << exit(FatalError);
    }
    return found;
}


//- Mole fractions: given, or of the first of two liquids from 0 to 1
List<scalarField> compositions
(
    const argList& args,
    const wordList& names,
    const bool liquid
)
{
    if (args.found("across"))
    {
        const label n = args.get<label>("across");
        if (n < 2 || names.size() != 2 || !liquid)
        {
            FatalErrorInFunction
                << "-across " << n << " of " << names << nl
                << "It takes 2 rows or more, and a mixture of two liquids"
                << exit(FatalError);
        }
        List<scalarField> x(n, scalarField(2));
        forAll(x, i)
        {
            x[i][0] = scalar(i)/(n - 1);
            x[i][1] = 1 - x[i][0];
        }
        return x;
    }

    scalarField x(names.size(), liquid ? 1.0/max(names.size(), 1) : 0);
    if (args.found("x"))
    {
        x = numbers(args, "x");
        if
        (
            x.size() != names.size() || min(x) < 0 || sum(x) > 1 + 1e-6
         || (liquid && sum(x) < 1 - 1e-6)
        )
        {
            FatalErrorInFunction
                << "Mole fractions -x " << x << " of " << names << nl
                << "Give one for each, of sum 1"
                << (liquid ? "" : " or less; the carrier is the rest")
                << exit(FatalError);
        }
    }
    return List<scalarField>(1, x);
}


void list()
{
    // Liquids of the library, with their common names
    wordList liquids
    (
        liquidProperties::dictionaryConstructorTablePtr_->sortedToc()
    );
    Info<< "Liquids:" << nl;
    for (const word& name : liquids)
    {
        const dew::speciesData* species = dew::speciesData::find(name);
        Info<< "    " << name
            << ' ' << (species ? species->commonName : "") << nl;
    }
    Info<< "Gases:" << nl << "    air H2O";
    for (const word& name : dew::gasFits::names())
    {
        if (name != "H2O")
        {
            Info<< ' ' << name;
        }
    }
    Info<< nl << "Activity models:" << nl << "    "
        << line
        (
            dew::activityModel::dictionaryConstructorTablePtr_->sortedToc()
        ).c_str()
        << nl << "Groups of UNIFAC:" << nl << "    "
        << line(dew::UNIFACGroups::names()).c_str() << nl << endl;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Tables of the properties of liquids and gases");
    argList::noBanner();
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addBoolOption("list", "List the known species and models");
    argList::addOption("liquid", "name", "Of a liquid of the library");
    argList::addOption("gas", "name", "Of a gas");
    argList::addOption("phase", "name", "liquid or gas of the case");
    argList::addBoolOption("VLE", "Boiling point and vapour over composition");
    argList::addOption("property", "name", "Only this one");
    argList::addOption("T", "T | (from to rows)", "Temperatures [K]");
    argList::addOption("p", "p", "Pressure [Pa]");
    argList::addOption("x", "list", "Mole fractions");
    argList::addOption("across", "rows", "From pure second to pure first");
    argList::addOption("csv", "file", "Write comma-separated values");
    argList::addOption("plot", "file", "Write a picture (with -csv)");

    argList args(argc, argv);
    if (args.found("list"))
    {
        list();
        return 0;
    }
    if (args.found("plot") && !args.found("csv"))
    {
        FatalErrorInFunction
            << "-plot without -csv" << nl << "Give the file to plot from"
            << exit(FatalError);
    }

    const word phase
    (
        args.found("VLE") ? word("VLE")
      : args.getOrDefault<word>("phase", "liquid")
    );
    autoPtr<dew::pureGas> pureGas;
    autoPtr<dew::liquidMixture> liquids;
    autoPtr<dew::vapourLiquidEquilibrium> equilibrium;
    autoPtr<dew::gasMixture> gas;
    properties all;
    if (args.found("gas"))
    {
        pureGas = dew::pureGases::mixedGas::species(args["gas"]);
        all = ofGas(pureGas());
    }
    else
    {
        dictionary dict;
        if (args.found("liquid"))
        {
            dict.add("type", word("library"));
            dict.add("liquid", word(args["liquid"]));
        }
        else
        {
            dict = caseDictionary(args, "liquidProperties");
        }
        liquids.reset(new dew::liquidMixture(dict));
        equilibrium.reset(new dew::vapourLiquidEquilibrium(liquids()));

        if (phase == "VLE")
        {
            all = ofBoiling(equilibrium());
        }
        else if (phase == "gas")
        {
            gas = dew::gasMixture::New
            (
                caseDictionary(args, "gasProperties"), liquids()
            );
            all = ofGasMixture(gas());
        }
        else if (phase == "liquid")
        {
            all =
                liquids->size() == 1
              ? ofLiquid(liquids->liquid(0))
              : ofMixture(liquids());
            if (liquids->size() > 1)
            {
                all.append(ofEquilibrium(equilibrium()));
            }
        }
        else
        {
            FatalErrorInFunction
                << "Unknown phase " << phase << nl << "It is liquid or gas"
                << exit(FatalError);
        }
    }

    const properties columns(chosen(args, all));
    const wordList names(liquids.valid() ? liquids->names() : wordList());
    const bool mixture = names.size() > 1 || gas.valid();
    DynamicList<word> header;
    header.append("T");
    if (mixture)
    {
        for (const word& name : names)
        {
            header.append("x." + name);
        }
    }
    const bool over = args.found("across");
    if (over)
    {
        // What is plotted over comes first
        Swap(header[0], header[1]);
    }
    for (const property& q : columns)
    {
        header.append(q.name);
    }

    dew::printedTable table{wordList(header)};
    const scalar p = args.getOrDefault<scalar>("p", 101325);
    bool told = false;
    for (const scalar T : temperatures(args))
    {
        if
        (
            !told && liquids.valid() && phase == "liquid"
         && !liquids->inRange(T)
        )
        {
            told = true;
            Info<< "At " << T << " K the properties of " << line(names).c_str()
                << " are extrapolated: they are trusted from "
                << liquids->Tmin() << " to " << liquids->Tmax() << " K" << nl
                << endl;
        }
        for (const scalarField& x : compositions(args, names, !gas.valid()))
        {
            DynamicList<scalar> row;
            row.append(T);
            if (mixture)
            {
                row.append(x);
            }
            if (over)
            {
                Swap(row[0], row[1]);
            }
            for (const property& q : columns)
            {
                row.append(q.value(p, T, x));
            }
            table.append(row);
        }
    }

    table.print(Info);
    if (args.found("csv"))
    {
        table.write(args["csv"]);
        if (args.found("plot"))
        {
            dew::printedTable::plot(args["csv"], args["plot"]);
        }
    }
    return 0;
}


// ************************************************************************* //
